// A transparent canvas over a drawing: what moves in every picture is drawn on it, and the drawing beneath stays as it is.

/** Lays a canvas over a box. Returns `draw(paint)`, which clears it and calls paint(context, width, height), in pixels of the page. */
export function createOverlay(box) {
  const canvas = document.createElement("canvas");
  canvas.className = "overlay";
  canvas.setAttribute("aria-hidden", "true");
  box.append(canvas);
  const context = canvas.getContext("2d");
  let size = "";

  function fit() {
    const [width, height] = [box.clientWidth, box.clientHeight];
    if (size !== `${width} ${height} ${devicePixelRatio}`) {
      size = `${width} ${height} ${devicePixelRatio}`;
      [canvas.width, canvas.height] = [Math.round(width * devicePixelRatio), Math.round(height * devicePixelRatio)];
    }
    return [width, height];
  }

  return function draw(paint) {
    const [width, height] = fit();
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.setLineDash([]);
    paint(context, width, height);
  };
}
