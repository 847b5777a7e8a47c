classdef algebra
%ALGEBRA  Generated algebra, for arrays of any one size; nested results come one after the other.
  methods (Static)
    function [result1, result2, result3] = scales(m, k_c, L_0)
    %SCALES  Scales of length, time and force. Returns length, time, force. Source: text after (9). Operations: 6.
      result1 = L_0;
      result2 = sqrt(m)./sqrt(k_c);
      result3 = L_0.*k_c;
    end

    function [result1, result2, result3, result4, result5, result6] = dimensionless_groups(m, k_c, L_0, F_L, k_x, k, k_y, ...
        V_dim, d_dim)
    %DIMENSIONLESS_GROUPS  The dimensionless parameters of dimensional data. Returns kappa, alpha, sigma, beta, V, d. Source: text
    %  after (9). Operations: 19.
      result1 = F_L./(L_0.*k_c);
      result2 = k_x./k_c;
      result3 = k./k_c;
      result4 = k_y./k_c;
      result5 = V_dim.*sqrt(m)./(L_0.*sqrt(k_c));
      result6 = L_0.*d_dim.*sqrt(k_c)./sqrt(m);
    end

    function [result1, result2, result3, result4] = contact_matrix(L, mu0, alpha, sigma, beta)
    %CONTACT_MATRIX  D of the balance in contact. Returns ((D11, D12), (D21, D22)). Source: (17), (18). Operations: 12.
      p = alpha + sigma;
      B = beta + 1;
      q = B + sigma;
      w0 = -sigma;
      result1 = -L.*p - w0;
      result2 = -L.*mu0;
      result3 = 0;
      result4 = -L.*q - w0;
    end

    function [result1, result2] = contact_vector(cos0, sin0, mu0, kappa, alpha, beta)
    %CONTACT_VECTOR  b of the balance in contact. Returns b1, b2. Source: (19), (A10), (A11). Operations: 8.
      result1 = -alpha.*cos0 - mu0.*sin0;
      result2 = -beta.*sin0 - kappa - sin0;
    end

    function [result1, result2, result3, result4, result5] = contact_quartic(cos0, sin0, mu0, kappa, alpha, sigma, beta)
    %CONTACT_QUARTIC  Coefficients of c0 + c1 L + c2 L² + c3 L³ + c4 L⁴ = 0 in contact. Returns c0, c1, c2, c3, c4. Source: (21),
    %  (A1)–(A5). Operations: 45.
      b1 = -mu0.*sin0 - alpha.*cos0;
      B = beta + 1;
      b2 = -B.*sin0 - kappa;
      p = alpha + sigma;
      q = B + sigma;
      b1_2 = b1.*b1;
      sigma_2 = sigma.*sigma;
      b2_2 = b2.*b2;
      w0 = -sigma_2;
      w1 = b2_2 + w0;
      w2 = 2.*sigma;
      base3 = mu0.*b2 - b1.*q;
      p_2 = p.*p;
      q_2 = q.*q;
      w3 = p.*q;
      result1 = sigma_2.*(b1_2 + w1);
      result2 = w2.*(mu0.*b1.*b2 - p.*w1 - q.*(b1_2 + w0));
      result3 = b2_2.*p_2 + base3.*base3 - sigma_2.*(p_2 + q_2 + 4.*w3);
      result4 = w2.*w3.*(p + q);
      result5 = -p_2.*q_2;
    end

    function [result1, result2, result3, result4] = liftoff_matrix(L, alpha, sigma, beta)
    %LIFTOFF_MATRIX  D of the balance in lift-off. Returns ((D11, D12), (D21, D22)). Source: (24). Operations: 9.
      p = alpha + sigma;
      q = beta + sigma;
      w0 = -sigma;
      result1 = -L.*p - w0;
      result2 = 0;
      result3 = 0;
      result4 = -L.*q - w0;
    end

    function [result1, result2] = liftoff_vector(cos0, sin0, kappa, alpha, beta)
    %LIFTOFF_VECTOR  b of the balance in lift-off. Returns b3, b4. Source: (25), (A12), (A13). Operations: 5.
      result1 = -alpha.*cos0;
      result2 = -beta.*sin0 - kappa;
    end

    function [result1, result2, result3, result4, result5] = liftoff_quartic(cos0, sin0, kappa, alpha, sigma, beta)
    %LIFTOFF_QUARTIC  Coefficients of d0 + d1 L + d2 L² + d3 L³ + d4 L⁴ = 0 in lift-off, d0 as derived. Returns d0, d1, d2, d3,
    %  d4. Source: (26), (A1) corrected, (A6)–(A9). Operations: 37.
      b1 = -alpha.*cos0;
      b2 = -beta.*sin0 - kappa;
      p = alpha + sigma;
      q = beta + sigma;
      b1_2 = b1.*b1;
      sigma_2 = sigma.*sigma;
      b2_2 = b2.*b2;
      w0 = -sigma_2;
      w1 = b2_2 + w0;
      w2 = 2.*sigma;
      p_2 = p.*p;
      q_2 = q.*q;
      w3 = p.*q;
      result1 = sigma_2.*(b1_2 + w1);
      result2 = w2.*(-p.*w1 - q.*(b1_2 + w0));
      result3 = b1_2.*q_2 + b2_2.*p_2 - sigma_2.*(p_2 + q_2 + 4.*w3);
      result4 = w2.*w3.*(p + q);
      result5 = -p_2.*q_2;
    end

    function [result1, result2] = singular_lengths(alpha, sigma, beta, nbar)
    %SINGULAR_LENGTHS  Spring lengths at which D is singular and (20) cannot give the state. Returns L at which D11 = 0, L at
    %  which D22 = 0. Source: (17). Operations: 5.
      result1 = sigma./(alpha + sigma);
      result2 = sigma./(beta + nbar + sigma);
    end

    function [a_f, b_f, d_f, m_f] = f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
    %F_COEFFICIENTS  a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ F_x(θ, L(θ)). Returns a, b, d, m.
    %  Source: (12), (13) eliminated. Operations: 17.
      B = beta + nbar;
      a_f = sigma.*(B - alpha);
      p = alpha + sigma;
      b_f = -p.*(B.*sin0 + kappa);
      M = mu0.*nbar;
      q = B + sigma;
      d_f = M.*(-kappa + sigma.*sin0) + alpha.*cos0.*q;
      m_f = M.*sigma;
    end

    function [result1, result2] = f_magnitudes(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
    %F_MAGNITUDES  Sums of the absolute values of the terms of a and d, against which their rounding errors are measured. Returns
    %  |a|, |d|. Source: rounding-error analysis. Operations: 12.
      B = beta + nbar;
      M = mu0.*nbar;
      q = B + sigma;
      result1 = sigma.*(B + alpha);
      result2 = M.*(kappa + sigma.*sin0) + alpha.*q.*abs(cos0);
    end

    function result1 = f(cos, sin, a_f, b_f, d_f, m_f)
    %F  The scalar function whose roots are the equilibria. Returns f. Source: (12), (13) eliminated. Operations: 9.
      result1 = a_f.*cos.*sin + b_f.*cos + d_f.*sin - m_f.*(sin.*sin);
    end

    function result1 = f_slope(cos, sin, a_f, b_f, d_f, m_f)
    %F_SLOPE  df/dθ, which is L det K at an equilibrium. Returns f′. Source: (12), (13) eliminated. Operations: 13.
      result1 = a_f.*(cos.*cos) - a_f.*(sin.*sin) + cos.*d_f + sin.*(-b_f - 2.*cos.*m_f);
    end

    function result1 = f_curvature(cos, sin, a_f, b_f, d_f, m_f)
    %F_CURVATURE  d²f/dθ². Returns f″. Source: (12), (13) eliminated. Operations: 15.
      result1 = -4.*a_f.*cos.*sin - b_f.*cos - 2.*(cos.*cos).*m_f - d_f.*sin + 2.*m_f.*(sin.*sin);
    end

    function result1 = f_third(cos, sin, a_f, b_f, d_f, m_f)
    %F_THIRD  d³f/dθ³. Returns f‴. Source: (12), (13) eliminated. Operations: 14.
      w0 = 4.*a_f;
      result1 = b_f.*sin - cos.*d_f + 8.*cos.*m_f.*sin - (cos.*cos).*w0 + (sin.*sin).*w0;
    end

    function [result1, result2, result3, result4, result5] = t_quartic(a_f, b_f, d_f, m_f)
    %T_QUARTIC  Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = tan(θ/2). Returns e0, e1, e2, e3, e4.
    %  Source: (12), (13) eliminated. Operations: 7.
      result1 = b_f;
      result2 = 2.*(a_f + d_f);
      result3 = -4.*m_f;
      result4 = 2.*(-a_f + d_f);
      result5 = -b_f;
    end

    function [result1, result2, result3] = resolvent(a_f, b_f, d_f, m_f)
    %RESOLVENT  Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of the quartic in t. Returns r0, r1, r2.
    %  Source: (12), (13) eliminated. Operations: 15.
      result1 = -b_f.*(a_f.*d_f + b_f.*m_f)./4;
      result2 = -(a_f.*a_f)./4 + (b_f.*b_f)./4 + (d_f.*d_f)./4;
      result3 = -m_f;
    end

    function [L, result2, result3] = state(cos, sin, cos0, sin0, kappa, sigma, beta, nbar)
    %STATE  Spring length and displacement at an equilibrium with direction θ. Returns L, x, y. Source: (4), (5), (13) or (15).
    %  Operations: 15.
      B = beta + nbar;
      q = B + sigma;
      w0 = 1./q;
      L = w0.*(B.*sin0 + kappa + sigma.*sin)./sin;
      result2 = -L.*cos + cos0;
      result3 = w0.*(-kappa + sigma.*(-sin + sin0));
    end

    function [result1, result2] = residuals(cos, sin, L, cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
    %RESIDUALS  F_x and F_y at spring length L and direction θ. Returns F_x, F_y. Source: (12)–(15). Operations: 17.
      w0 = sigma.*(1 - L);
      w1 = -L.*sin + sin0;
      result1 = alpha.*(-L.*cos + cos0) + cos.*w0 + mu0.*nbar.*w1;
      result2 = kappa + sin.*w0 + w1.*(beta + nbar);
    end

    function [result1, result2, w1, result4] = stiffness(cos, sin, L, mu0, alpha, sigma, beta, nbar)
    %STIFFNESS  K, the Jacobian of (F_x, F_y). Returns ((K11, K12), (K21, K22)). Source: (28). Operations: 14.
      p = alpha + sigma;
      M = mu0.*nbar;
      B = beta + nbar;
      q = B + sigma;
      w0 = sigma./L;
      w1 = cos.*sin.*w0;
      result1 = p - (sin.*sin).*w0;
      result2 = M + w1;
      result4 = -(cos.*cos).*w0 + q;
    end

    function [result1, result2, result3] = invariants(K11, K12, K21, K22)
    %INVARIANTS  Trace, determinant (negative: divergence) and discriminant in λ² (negative: flutter) of K. Returns trace,
    %  determinant, discriminant. Source: (27). Operations: 8.
      w0 = K12.*K21;
      base0 = K11 - K22;
      result1 = K11 + K22;
      result2 = K11.*K22 - w0;
      result3 = base0.*base0 + 4.*w0;
    end

    function result1 = damping(y, mu0, V, d, nbar)
    %DAMPING  ∂F_x/∂x' at steady sliding. Returns C11. Source: (8), (10) linearized. Operations: 7.
      result1 = -d.*mu0.*nbar.*y.*exp(-V.*d);
    end

    function [result1, result2, result3, result4, result5] = characteristic(K11, K12, K21, K22, C11)
    %CHARACTERISTIC  Coefficients of det(λ² I + λ C + K), highest power first; C11 = 0 is (27). Returns e4, e3, e2, e1, e0.
    %  Source: (27) with damping. Operations: 5.
      result1 = 1;
      result2 = C11;
      result3 = K11 + K22;
      result4 = C11.*K22;
      result5 = K11.*K22 - K12.*K21;
    end

    function [result1, result2, result3, result4] = reference_lines(cos, sin, mu0, kappa, alpha, sigma, beta)
    %REFERENCE_LINES  u1, w1, u2, w2 of sin θ₀ = u1 + w1 L and α cos θ₀ = u2 + w2 L, in contact at given θ and μ₀. Returns u1, w1,
    %  u2, w2. Source: (14), (15). Operations: 18.
      B = beta + 1;
      q = B + sigma;
      p = alpha + sigma;
      w0 = 1./B;
      w1 = sigma.*sin;
      w2 = kappa + w1;
      result1 = -w0.*w2;
      result2 = q.*sin.*w0;
      result3 = mu0.*w0.*w2 - cos.*sigma;
      result4 = -mu0.*w0.*w1 + cos.*p;
    end

    function [result1, result2, result3] = flutter_quadratic(cos, sin, mu0, alpha, sigma, beta)
    %FLUTTER_QUADRATIC  Coefficients of e0 + e1 L + e2 L², which is L² times the discriminant of (27), in contact. Returns e0, e1,
    %  e2. Source: (27). Operations: 14.
      B = beta + 1;
      w0 = -B + alpha;
      result1 = sigma.*sigma;
      result2 = 2.*sigma.*(2.*mu0.*cos.*sin + w0.*(cos.*cos - (sin.*sin)));
      result3 = w0.*w0;
    end

    function [result1, result2, result3] = flutter_elimination(cos, sin, mu0, kappa, alpha, sigma, beta)
    %FLUTTER_ELIMINATION  X, Y, Z: X² = Y Z at the θ of every flutter onset in contact, and L = X/Y is its length. Returns X, Y,
    %  Z. Source: (27), (14), (15). Operations: 56.
      B = beta + 1;
      w5 = -B + alpha;
      w0 = 1./B;
      w3 = sigma.*sin;
      w4 = kappa + w3;
      u1 = -w0.*w4;
      u2 = mu0.*w0.*w4 - cos.*sigma;
      q = B + sigma;
      w1 = q.*sin.*w0;
      p = alpha + sigma;
      w2 = -mu0.*w0.*w3 + cos.*p;
      e1 = 2.*sigma.*(2.*mu0.*cos.*sin + w5.*(cos.*cos - (sin.*sin)));
      alpha_2 = alpha.*alpha;
      w6 = alpha_2.*(w1.*w1) + w2.*w2;
      w7 = alpha_2.*(u1.*u1 - 1) + u2.*u2;
      w8 = 2.*alpha_2.*u1.*w1 + 2.*u2.*w2;
      result1 = (sigma.*sigma).*w6 - (w5.*w5).*w7;
      result2 = -e1.*w6 + (w5.*w5).*w8;
      result3 = -(sigma.*sigma).*w8 + e1.*w7;
    end

    function result1 = flutter_without_alpha(cos, sin, mu0, kappa, sigma, beta)
    %FLUTTER_WITHOUT_ALPHA  The same for α = 0: zero at the θ of every flutter onset, where L = −u2/w2. Returns condition. Source:
    %  (27), (14), (15). Operations: 32.
      B = beta + 1;
      e1 = 2.*sigma.*(-B.*(cos.*cos - (sin.*sin)) + 2.*mu0.*cos.*sin);
      w0 = 1./B;
      w3 = sigma.*sin;
      u2 = mu0.*w0.*(kappa + w3) - cos.*sigma;
      w2 = -mu0.*w0.*w3 + cos.*sigma;
      result1 = (sigma.*sigma).*(w2.*w2) - e1.*u2.*w2 + (B.*B).*(u2.*u2);
    end

    function [result1, result2] = flutter_crossing(cos, sin, L, cos0, sin0, mu0, alpha, sigma, beta)
    %FLUTTER_CROSSING  N, J: L² times the discriminant changes by N/J per unit of θ₀, along equilibria in contact. Returns N, J.
    %  Source: (27), (14), (15). Operations: 60.
      p = alpha + sigma;
      w0 = mu0.*sin;
      a_L = -cos.*p - w0;
      w1 = -sigma;
      a_theta = -L.*mu0.*cos + sin.*(L.*p + w1);
      a_theta0 = mu0.*cos0 - alpha.*sin0;
      B = beta + 1;
      q = B + sigma;
      b_L = -q.*sin;
      b_theta = -cos.*(L.*q + w1);
      b_theta0 = B.*cos0;
      w2 = -B + alpha;
      w3 = cos.*cos - (sin.*sin);
      d_L = 2.*L.*(w2.*w2) + 2.*sigma.*(2.*cos.*w0 + w2.*w3);
      d_theta = 4.*L.*sigma.*(mu0.*w3 - cos.*sin.*(-2.*B + 2.*alpha));
      result1 = d_L.*(a_theta.*b_theta0 - a_theta0.*b_theta) + d_theta.*(-a_L.*b_theta0 + a_theta0.*b_L);
      result2 = a_L.*b_theta - a_theta.*b_L;
    end

    function [result1, result2, result3, result4, result5, result6] = flutter_cubic(cos, sin, kappa, alpha, sigma, beta)
    %FLUTTER_CUBIC  Flutter onsets in contact at a given θ: cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 sin θ₀ + … + k3 sin³ θ₀. Returns g0,
    %  g1, k0, k1, k2, k3. Source: (27), (14), (15). Operations: 59.
      B = beta + 1;
      q = B + sigma;
      w0 = sigma.*sin;
      w1 = kappa + w0;
      w2 = 1./q;
      w3 = w2./sin;
      l0 = w1.*w3;
      l1 = B.*w3;
      sigma_2 = sigma.*sigma;
      cos_2 = cos.*cos;
      w4 = -B + alpha;
      e1 = 2.*sigma.*w4.*(cos_2 - (sin.*sin));
      w5 = 4.*cos_2;
      m1 = -sigma_2.*sin.*w5;
      p = alpha + sigma;
      m2 = p.*w0.*w5;
      y0 = -w1.*w2;
      y1 = sigma.*w2;
      w6 = 4.*alpha.*cos.*w0;
      w7 = l0.*m2;
      w8 = (w4.*w4).*l0;
      w9 = sigma_2 + l0.*(e1 + w8);
      w10 = l1.*(e1 + 2.*w8);
      l1_2 = l1.*l1;
      w11 = (w4.*w4).*l1_2;
      result1 = l0.*w6;
      result2 = l1.*w6;
      result3 = l0.*(m1 + w7) + w9.*y0;
      result4 = l1.*(m1 + 2.*w7) + w10.*y0 + w9.*y1;
      result5 = l1_2.*m2 + w10.*y1 + w11.*y0;
      result6 = w11.*y1;
    end

    function result1 = flutter_friction(cos, sin, L, alpha, sigma, beta)
    %FLUTTER_FRICTION  μ₀ at a flutter onset with spring length L in direction θ, in contact. Returns mu0. Source: (27).
    %  Operations: 21.
      B = beta + 1;
      w0 = -B + alpha;
      result1 = (-2.*L.*sigma.*w0.*(cos.*cos - (sin.*sin)) - (L.*L).*(w0.*w0) - (sigma.*sigma))./(4.*L.*cos.*sigma.*sin);
    end

    function result1 = surface(cos, sin, cos0, sin0, kappa, alpha, sigma, beta)
    %SURFACE  μ₀ on the equilibrium surface over (θ, θ₀): f is linear in μ₀. Returns mu0. Source: (14), (15). Operations: 22.
      B = beta + 1;
      a_f = sigma.*(B - alpha);
      p = alpha + sigma;
      b_f = -p.*(B.*sin0 + kappa);
      q = B + sigma;
      result1 = (a_f.*cos.*sin + alpha.*cos0.*q.*sin + b_f.*cos)./(sin.*(kappa - sigma.*(-sin + sin0)));
    end

    function [result1, result2] = fold_residuals(cos, sin, a_f, b_f, d_f, m_f)
    %FOLD_RESIDUALS  Both are zero exactly where f = f′ = 0. Returns b − b(fold), d − d(fold). Source: f = f′ = 0. Operations: 14.
      cos_2 = cos.*cos;
      result1 = b_f + (sin.*sin).*(a_f.*sin + cos.*m_f);
      result2 = a_f.*(cos.*cos_2) + d_f - m_f.*sin.*(cos_2 + 1);
    end

    function [result1, result2, result3, result4] = fold_lines_mu0(cos, sin, cos0, sin0, kappa, alpha, sigma, beta)
    %FOLD_LINES_MU0  The two fold relations as lines in mu0: u1 + w1 mu0 = 0 and u2 + w2 mu0 = 0. Returns u1, w1, u2, w2. Source:
    %  f = f′ = 0. Operations: 41.
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w0 = alpha.*sin0;
      w1 = sigma.*sin0;
      w2 = alpha.*cos0;
      cos_2 = cos.*cos;
      w3 = (cos.*cos_2).*sigma;
      w4 = sigma.*sin;
      result1 = -alpha.*kappa - alpha.*sigma.*sin_3 + beta.*sigma.*sin_3 - beta.*w0 - beta.*w1 - kappa.*sigma + sigma.*sin_3 - ...
          w0 - w1;
      result2 = cos.*sigma.*sin_2;
      result3 = -alpha.*w3 + beta.*w2 + beta.*w3 + sigma.*w2 + w2 + w3;
      result4 = -cos_2.*w4 - kappa + w1 - w4;
    end

    function [result1, result2, result3, result4] = fold_lines_kappa(cos, sin, cos0, sin0, mu0, alpha, sigma, beta)
    %FOLD_LINES_KAPPA  The two fold relations as lines in kappa: u1 + w1 kappa = 0 and u2 + w2 kappa = 0. Returns u1, w1, u2, w2.
    %  Source: f = f′ = 0. Operations: 44.
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w0 = alpha.*sin0;
      w1 = sigma.*sin0;
      cos_2 = cos.*cos;
      w2 = alpha.*cos0;
      w3 = (cos.*cos_2).*sigma;
      w4 = mu0.*sigma.*sin;
      result1 = -alpha.*sigma.*sin_3 + beta.*sigma.*sin_3 - beta.*w0 - beta.*w1 + cos.*mu0.*sigma.*sin_2 + sigma.*sin_3 - w0 - w1;
      result2 = -alpha - sigma;
      result3 = -alpha.*w3 + beta.*w2 + beta.*w3 - cos_2.*w4 + mu0.*w1 + sigma.*w2 + w2 + w3 - w4;
      result4 = -mu0;
    end

    function [result1, result2, result3, result4] = fold_lines_alpha(cos, sin, cos0, sin0, mu0, kappa, sigma, beta)
    %FOLD_LINES_ALPHA  The two fold relations as lines in alpha: u1 + w1 alpha = 0 and u2 + w2 alpha = 0. Returns u1, w1, u2, w2.
    %  Source: f = f′ = 0. Operations: 34.
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w0 = beta.*sin0 + kappa + sin0;
      cos_2 = cos.*cos;
      w1 = (cos.*cos_2).*sigma;
      w2 = mu0.*sigma;
      w3 = sin.*w2;
      result1 = sigma.*(beta.*sin_3 + cos.*mu0.*sin_2 + sin_3 - w0);
      result2 = -sigma.*sin_3 - w0;
      result3 = beta.*w1 - cos_2.*w3 - kappa.*mu0 + sin0.*w2 + w1 - w3;
      result4 = beta.*cos0 + cos0.*sigma + cos0 - w1;
    end

    function [result1, result2, result3, result4] = fold_lines_sigma(cos, sin, cos0, sin0, mu0, kappa, alpha, beta)
    %FOLD_LINES_SIGMA  The two fold relations as lines in sigma: u1 + w1 sigma = 0 and u2 + w2 sigma = 0. Returns u1, w1, u2, w2.
    %  Source: f = f′ = 0. Operations: 33.
      w0 = beta.*sin0 + kappa + sin0;
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w1 = alpha.*cos0;
      cos_2 = cos.*cos;
      cos_3 = cos.*cos_2;
      w2 = mu0.*sin;
      result1 = -alpha.*w0;
      result2 = -alpha.*sin_3 + beta.*sin_3 + cos.*mu0.*sin_2 + sin_3 - w0;
      result3 = beta.*w1 - kappa.*mu0 + w1;
      result4 = -alpha.*cos_3 + beta.*cos_3 - cos_2.*w2 + cos_3 + mu0.*sin0 + w1 - w2;
    end

    function [result1, result2, result3, w5] = fold_lines_beta(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma)
    %FOLD_LINES_BETA  The two fold relations as lines in beta: u1 + w1 beta = 0 and u2 + w2 beta = 0. Returns u1, w1, u2, w2.
    %  Source: f = f′ = 0. Operations: 37.
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w0 = sigma.*sin0;
      w1 = alpha.*sin0 - sigma.*sin_3 + w0;
      cos_2 = cos.*cos;
      w2 = alpha.*cos0;
      w3 = (cos.*cos_2).*sigma;
      w4 = mu0.*sigma.*sin;
      w5 = w2 + w3;
      result1 = -alpha.*kappa - alpha.*sigma.*sin_3 + cos.*mu0.*sigma.*sin_2 - kappa.*sigma - w1;
      result2 = -w1;
      result3 = -alpha.*w3 - cos_2.*w4 - kappa.*mu0 + mu0.*w0 + sigma.*w2 - w4 + w5;
    end

    function [w1, result2] = fold_angles(cos, sin, mu0, kappa, alpha, sigma, beta)
    %FOLD_ANGLES  sin θ₀ and cos θ₀ of the fold through θ at friction μ₀. Needs α > 0. Returns sin0, cos0. Source: f = f′ = 0.
    %  Operations: 34.
      B = beta + 1;
      p = alpha + sigma;
      q = B + sigma;
      sin_2 = sin.*sin;
      w0 = B.*sigma;
      w1 = (-kappa.*p + sigma.*sin_2.*(-alpha.*sin + cos.*mu0) + (sin.*sin_2).*w0)./(B.*p);
      cos_2 = cos.*cos;
      cos_3 = cos.*cos_2;
      w2 = mu0.*sigma;
      w3 = sin.*w2;
      result2 = (alpha.*cos_3.*sigma + cos_2.*w3 - cos_3.*w0 + kappa.*mu0 - w1.*w2 + w3)./(alpha.*q);
    end

    function result1 = fold_sine(cos, sin, mu0, kappa, alpha, sigma, beta)
    %FOLD_SINE  sin θ₀ of the fold through θ at friction μ₀, for any α ≥ 0. Returns sin0. Source: f = f′ = 0. Operations: 16.
      B = beta + 1;
      p = alpha + sigma;
      sin_2 = sin.*sin;
      result1 = (B.*sigma.*(sin.*sin_2) - kappa.*p + sigma.*sin_2.*(-alpha.*sin + cos.*mu0))./(B.*p);
    end

    function [result1, result2, result3, result4, result5] = fold_quartic(cos, sin, kappa, alpha, sigma, beta)
    %FOLD_QUARTIC  Coefficients of e0 + … + e4 μ₀⁴, whose real roots are all folds at a given θ. Needs α > 0. Returns e0, e1, e2,
    %  e3, e4. Source: f = f′ = 0. Operations: 52.
      B = beta + 1;
      q = B + sigma;
      cos_2 = cos.*cos;
      w0 = 1./(alpha.*q);
      w1 = sigma.*w0;
      g0 = (cos.*cos_2).*w1.*(-B + alpha);
      p = alpha + sigma;
      sin_2 = sin.*sin;
      sin_3 = sin.*sin_2;
      w2 = 1./(B.*p);
      u0 = w2.*(B.*sigma.*sin_3 - alpha.*sigma.*sin_3 - kappa.*p);
      w3 = sigma.*sin;
      g1 = w0.*(cos_2.*w3 + kappa - sigma.*u0 + w3);
      u1 = cos.*sigma.*sin_2.*w2;
      g2 = -u1.*w1;
      w4 = 2.*g0;
      result1 = g0.*g0 + u0.*u0 - 1;
      result2 = g1.*w4 + 2.*u0.*u1;
      result3 = g1.*g1 + g2.*w4 + u1.*u1;
      result4 = 2.*g1.*g2;
      result5 = g2.*g2;
    end

    function [result1, result2, result3, result4] = fold_conic(cos, sin, kappa, alpha, sigma, beta)
    %FOLD_CONIC  All folds at a given θ, friction eliminated: E0 + E1 sin θ₀ + E2 sin² θ₀ + Ec cos θ₀ = 0, for any α ≥ 0. Returns
    %  E0, E1, E2, Ec. Source: f = f′ = 0. Operations: 32.
      B = beta + 1;
      a_f = sigma.*(B - alpha);
      p = alpha + sigma;
      q = B + sigma;
      sin_2 = sin.*sin;
      w0 = kappa + sigma.*sin.*(2 - sin_2);
      w1 = B.*p;
      result1 = -a_f.*sin_2.*(kappa.*sin + sigma) + kappa.*p.*w0;
      result2 = -sigma.*(-a_f.*(sin.*sin_2) + kappa.*p) + w0.*w1;
      result3 = -sigma.*w1;
      result4 = -alpha.*cos.*q.*sigma.*sin_2;
    end

    function [result1, product, result3] = fold_events(sin, kappa, alpha, sigma, beta)
    %FOLD_EVENTS  Polynomials in s = sin θ that are 0 at a θ < π/2 where two folds meet, where one has θ₀ = 0 or π, and where one
    %  has μ₀ = 0. Needs α > 0. Returns meeting, border, frictionless. Source: f = f′ = 0. Operations: 76.
      B = beta + 1;
      a_f = sigma.*(B - alpha);
      p = alpha + sigma;
      sin_2 = sin.*sin;
      w0 = a_f.*(sin.*sin_2) - kappa.*p;
      w1 = kappa + sigma.*sin.*(2 - sin_2);
      w2 = B.*p;
      e1 = sigma.*w0 + w1.*w2;
      e0 = -a_f.*sin_2.*(kappa.*sin + sigma) + kappa.*p.*w1;
      e2 = -sigma.*w2;
      middle = 2.*e0 + 4.*e2;
      q = B + sigma;
      w3 = 1 - sin_2;
      w4 = (alpha.*alpha).*(q.*q);
      ec_2 = (sigma.*sigma).*(sin_2.*sin_2).*w3.*w4;
      product = e0.*e0 - ec_2;
      e1_2 = e1.*e1;
      middle_2 = middle.*middle;
      P = -12.*e1_2 + middle_2 + 12.*product;
      Q = -216.*e0.*e1_2 + 36.*e1_2.*middle + 72.*middle.*product - 2.*(middle.*middle_2);
      w5 = (B.*B).*(p.*p);
      result1 = 4.*(P.*(P.*P)) - (Q.*Q);
      result3 = (a_f.*a_f).*(w3.*(w3.*w3)).*w5 + (w0.*w0).*w4 - w4.*w5;
    end

    function [result1, e0, result3] = fold_events_without_alpha(sin, kappa, sigma, beta)
    %FOLD_EVENTS_WITHOUT_ALPHA  The same for α = 0: 0 where two folds meet, where two have θ₀ = 0 and π, and where they meet at
    %  π/2. Returns meeting, border, middle. Source: f = f′ = 0. Operations: 45.
      B = beta + 1;
      w0 = B.*sigma;
      sin_2 = sin.*sin;
      w1 = kappa + sigma.*sin.*(2 - sin_2);
      e0 = -w0.*sin_2.*(kappa.*sin + sigma) + kappa.*sigma.*w1;
      e1 = -sigma.*(-w0.*(sin.*sin_2) + kappa.*sigma) + w0.*w1;
      e2 = -B.*(sigma.*sigma);
      w2 = sin - 1;
      w3 = -w2;
      result1 = -4.*e0.*e2 + e1.*e1;
      result3 = sigma.*(kappa.*kappa + w3.*(B.*kappa.*(sin + sin_2 + 1) - kappa.*sigma.*(-sin_2 - w2) - w0.*w3));
    end

    function [result1, result2, result3] = fold_quadratic(cos, sin, kappa, sigma, beta)
    %FOLD_QUADRATIC  The same for α = 0: e0 + e1 μ₀ + e2 μ₀², and sin θ₀ as for α > 0. Returns e0, e1, e2. Source: f = f′ = 0.
    %  Operations: 23.
      B = beta + 1;
      cos_2 = cos.*cos;
      sigma_2 = sigma.*sigma;
      sin_2 = sin.*sin;
      w0 = B.*sigma;
      w1 = sin.*w0;
      result1 = (B.*B).*(cos.*cos_2).*sigma_2;
      result2 = -sigma.*(B.*kappa + cos_2.*w1 + kappa.*sigma - (sin.*sin_2).*w0 + w1);
      result3 = cos.*sigma_2.*sin_2;
    end

    function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12, ...
        result13, result14, result15, result16, result17, result18, result19, result20, result21, result22, w4, result24] = ...
        f_changes(cos0, sin0, mu0, kappa, alpha, sigma, beta)
    %F_CHANGES  Derivatives of a, b, d, m of f in contact by v = θ₀, μ₀, κ, α, σ, β in turn. Returns ((a_θ₀, b_θ₀, d_θ₀, m_θ₀), …,
    %  (a_β, b_β, d_β, m_β)). Source: (12), (13) eliminated. Operations: 26.
      w0 = alpha + sigma;
      w1 = beta + 1;
      w2 = sigma + w1;
      w3 = -kappa - sin0.*w1;
      w4 = alpha.*cos0;
      result1 = 0;
      result2 = -cos0.*w0.*w1;
      result3 = -alpha.*sin0.*w2 + cos0.*mu0.*sigma;
      result4 = 0;
      result5 = 0;
      result6 = 0;
      result7 = -kappa + sigma.*sin0;
      result8 = sigma;
      result9 = 0;
      result10 = -w0;
      result11 = -mu0;
      result12 = 0;
      result13 = -sigma;
      result14 = w3;
      result15 = cos0.*w2;
      result16 = 0;
      result17 = -alpha + w1;
      result18 = w3;
      result19 = mu0.*sin0 + w4;
      result20 = mu0;
      result21 = sigma;
      result22 = -sin0.*w0;
      result24 = 0;
    end

    function [result1, result2, w3, w6] = f_in_differences(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma, beta)
    %F_IN_DIFFERENCES  f, f′ and their derivatives by μ₀ in contact, with sin θ − sin θ₀ and cos θ₀ − cos θ kept together: over a
    %  box of parameters, or near small deformation, little is lost. Returns f, f′, f_μ₀, f′_μ₀. Source: (12), (13) eliminated.
    %  Operations: 47.
      B = beta + 1;
      w0 = sin - sin0;
      w1 = B.*w0 - kappa;
      w2 = kappa + sigma.*w0;
      w3 = -sin.*w2;
      w4 = -cos + cos0;
      w5 = sigma.*sin;
      w6 = cos.*(-w2 - w5);
      result1 = alpha.*(B.*(-cos.*sin0 + cos0.*sin) - cos.*kappa + w4.*w5) + cos.*sigma.*w1 + mu0.*w3;
      result2 = alpha.*(B.*(cos.*cos0 + sin.*sin0) + kappa.*sin + sigma.*(cos.*w4 + sin.*sin)) + mu0.*w6 + ...
          sigma.*(B.*(cos.*cos) - sin.*w1);
    end

    function [result1, result2, result3, result4, result5, result6, result7] = fold_sextic(a_f, b_f, d_f, m_f, a_v, b_v, d_v, m_v)
    %FOLD_SEXTIC  Coefficients of e0 + … + e6 t⁶ = (1 + t²)³ (f′ f_v − f f_v′) with t = tan(θ/2), whose roots are all folds along
    %  a parameter v but θ₀; minus its sign is that of dv/dθ on the surface. Returns e0, …, e6. Source: f = f′ = 0. Operations:
    %  34.
      ab = a_f.*b_v - a_v.*b_f;
      bd = b_f.*d_v - b_v.*d_f;
      bm = b_f.*m_v - b_v.*m_f;
      am = a_f.*m_v - a_v.*m_f;
      dm = d_f.*m_v - d_v.*m_f;
      ad = a_f.*d_v - a_v.*d_f;
      w0 = 4.*bm;
      w1 = 3.*bd;
      w2 = 3.*ab - 4.*dm;
      result1 = ab - bd;
      result2 = w0;
      result3 = 4.*am - w1 - w2;
      result4 = -8.*ad;
      result5 = 4.*am - w1 + w2;
      result6 = w0;
      result7 = -ab - bd;
    end

    function [result1, result2, w4, w5, w6, result6, result7, result8, result9, result10, result11, result12, result13, ...
        result14] = fold_cubics(mu0, kappa, alpha, sigma, beta)
    %FOLD_CUBICS  Coefficients in t = tan(θ/2) of (1 + t²)³ times p B sin θ₀ and p B q α cos θ₀, on the fold through θ at friction
    %  μ₀. Returns (S0, …, S6), (C0, …, C6). Source: f = f′ = 0. Operations: 35.
      p = alpha + sigma;
      m_f = mu0.*sigma;
      B = beta + 1;
      a_f = sigma.*(B - alpha);
      w0 = kappa.*p;
      w1 = -w0;
      w2 = 4.*m_f;
      w3 = 3.*w0;
      w4 = w2 - w3;
      w5 = 8.*a_f;
      w6 = -w2 - w3;
      w7 = m_f.*w0;
      w8 = mu0.*kappa;
      w9 = B.*p;
      w10 = w2.*w9;
      w11 = 3.*a_f;
      w12 = 3.*w8;
      result1 = w1;
      result2 = 0;
      result6 = 0;
      result7 = w1;
      result8 = w7 + w9.*(-a_f + w8);
      result9 = w10;
      result10 = -m_f.*w4 + w9.*(w11 + w12);
      result11 = -m_f.*w5;
      result12 = -m_f.*w6 + w9.*(-w11 + w12);
      result13 = w10;
      result14 = w7 + w9.*(a_f + w8);
    end

    function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10] = ...
        cusp_polynomial(kappa, alpha, sigma, beta)
    %CUSP_POLYNOMIAL  Coefficients of e0 + … + e9 s⁹, whose real roots s = sin θ in (−1, 1) are all cusps. Needs α > 0 and α ≠ 1 +
    %  β. Returns e0, …, e9. Source: f = f′ = f″ = 0. Operations: 103.
      B = beta + 1;
      p = alpha + sigma;
      g0 = -4.*B.*p.*sigma;
      k = kappa.*p;
      q = B + sigma;
      r = alpha.*q;
      w0 = B - alpha;
      g1 = -6.*k.*q;
      a_f = sigma.*w0;
      g4 = 3.*r.*sigma;
      width_2 = w0.*w0;
      w1 = (g0.*g0).*width_2;
      k_2 = k.*k;
      r_2 = r.*r;
      w2 = k_2.*r_2;
      w3 = 16.*r_2;
      w4 = (B.*B).*(p.*p);
      w5 = g0.*width_2;
      w6 = g1.*w5;
      w7 = (g1.*g1).*width_2;
      w8 = 3.*w1;
      w9 = r_2.*w4;
      w10 = a_f.*k;
      w11 = 216.*w2;
      w12 = 216.*w9;
      w13 = 2.*g4;
      w14 = r_2.*w10;
      w15 = g1.*width_2;
      w16 = (a_f.*a_f).*r_2;
      result1 = w1 + 16.*w2 - w3.*w4;
      result2 = 2.*w6;
      result3 = -96.*w2 + w7 - w8 + 96.*w9;
      result4 = w10.*w3 - 7.*w6;
      result5 = w11 - w12 + w13.*w5 - 4.*w7 + w8;
      result6 = w13.*w15 - 72.*w14 + 8.*w6;
      result7 = -4.*g4.*w5 - w1 - w11 + w12 + 4.*w16 + 21.*w7./4;
      result8 = 108.*a_f.*k.*r_2 - 5.*g4.*w15 - 3.*w6;
      result9 = 2.*g0.*g4.*width_2 + (g4.*g4).*width_2 + 81.*k_2.*r_2 - 12.*w16 - 9.*w7./4 - 81.*w9;
      result10 = 3.*g1.*g4.*width_2 - 54.*w14;
    end

    function [result1, result2, w0, result4] = cusp_cubic(kappa, sigma, beta)
    %CUSP_CUBIC  The same for α = 0: e0 + e1 s + e2 s² + e3 s³. Returns e0, e1, e2, e3. Source: f = f′ = f″ = 0. Operations: 9.
      B = beta + 1;
      w0 = 4.*B.*sigma;
      w1 = kappa.*(B + sigma);
      result1 = -w0;
      result2 = -6.*w1;
      result4 = 9.*w1;
    end

    function [result1, result2, result3] = cusp_point(sin, kappa, alpha, sigma, beta)
    %CUSP_POINT  sin θ₀, and cos θ₀ and μ₀ over cos θ, on a cusp. Needs α > 0 for the second. Returns sin0, cos0/cos, mu0/cos.
    %  Source: f = f′ = f″ = 0. Operations: 45.
      B = beta + 1;
      p = alpha + sigma;
      q = B + sigma;
      w0 = B - alpha;
      a_f = sigma.*w0;
      sin_2 = sin.*sin;
      w2 = 1./B;
      w3 = 1./p;
      w1 = 3.*sin_2 - 2;
      w4 = 1./w1;
      w5 = 3.*q;
      result1 = w2.*(-kappa + sigma.*(sin.*sin_2).*w0.*w3.*w4);
      result2 = w0.*w2.*w3.*(-4.*B.*p.*sigma.*(1 - sin_2) + alpha.*sigma.*(sin_2.*sin_2).*w5 + ...
          kappa.*p.*sin.*w1.*w5)./(alpha.*q.*(w1.*w1));
      result3 = 3.*a_f.*sin.*w4./sigma;
    end

    function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12] = ...
        unfolding(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma, beta)
    %UNFOLDING  ∂f/∂v and ∂f′/∂v for v = θ₀, μ₀, κ, α, σ, β in turn. Returns ((f_θ₀, f′_θ₀), …, (f_β, f′_β)). Source: f = f′ = 0.
    %  Operations: 90.
      w0 = alpha + sigma;
      w1 = cos0.*(alpha.*beta + beta.*sigma + w0);
      w2 = alpha.*sin0;
      w3 = -beta.*w2 + cos0.*mu0.*sigma - sigma.*w2 - w2;
      w4 = sigma.*sin;
      w5 = sigma.*sin0;
      w6 = kappa - w5;
      w7 = mu0.*sin;
      w10 = beta.*sin0 + kappa + sin0;
      w8 = beta + 1;
      w9 = sigma + w8;
      sin_2 = sin.*sin;
      w11 = sigma.*sin_2;
      cos_2 = cos.*cos;
      w12 = cos_2.*sigma;
      w13 = sin.*w10;
      w14 = alpha.*cos0;
      w15 = mu0.*sin0 + w14;
      w16 = alpha.*sin;
      w17 = -alpha + w8;
      result1 = -cos.*w1 + sin.*w3;
      result2 = cos.*w3 + sin.*w1;
      result3 = sin.*(-w4 - w6);
      result4 = cos.*(-2.*w4 - w6);
      result5 = -cos.*w0 - w7;
      result6 = -cos.*mu0 + sin.*w0;
      result7 = -cos.*(w10 + w4) + cos0.*sin.*w9;
      result8 = cos.*cos0.*w9 + w11 - w12 + w13;
      result9 = cos.*(beta.*sin + sin - w10 - w16) - mu0.*sin_2 + sin.*w15;
      result10 = cos.*(w15 - 2.*w7) + cos_2.*w17 - sin_2.*w17 + w13;
      result11 = cos.*(-w2 + w4 - w5) + cos0.*w16;
      result12 = cos.*w14 + sin.*sin0.*w0 - w11 + w12;
    end

    function [result1, result2] = cusp_sine(sin, kappa, alpha, sigma, beta)
    %CUSP_SINE  sin θ₀, and μ₀ over cos θ, on a cusp, for any α ≥ 0. Returns sin0, mu0/cos. Source: f = f′ = f″ = 0. Operations:
    %  19.
      B = beta + 1;
      p = alpha + sigma;
      w0 = B - alpha;
      a_f = sigma.*w0;
      sin_2 = sin.*sin;
      w1 = 1./(3.*sin_2 - 2);
      result1 = (-kappa + sigma.*(sin.*sin_2).*w0.*w1./p)./B;
      result2 = 3.*a_f.*sin.*w1./sigma;
    end

    function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10] = ...
        turning_polynomial(kappa, alpha, sigma, beta)
    %TURNING_POLYNOMIAL  Coefficients of e0 + … + e9 s⁹, among whose roots s = sin θ in (0, 1] are all points at which the curve
    %  of folds turns back in μ₀. Needs α > 0. Returns e0, …, e9. Source: f = f′ = f_θ₀ = 0. Operations: 280.
      B = beta + 1;
      w0 = alpha + sigma;
      w0_2 = w0.*w0;
      w2 = (B - kappa).*(B + kappa);
      kappa_2 = kappa.*kappa;
      w3 = alpha.*kappa_2;
      sigma_2 = sigma.*sigma;
      w4 = alpha.*sigma_2;
      w5 = kappa_2.*sigma;
      w6 = 2.*w5;
      w7 = 2.*sigma;
      B_2 = B.*B;
      alpha_2 = alpha.*alpha;
      sigma_3 = sigma.*sigma_2;
      sigma_4 = sigma_2.*sigma_2;
      w10 = 3.*B_2;
      w11 = 2.*alpha;
      w8 = B_2.*alpha_2;
      w12 = sigma_2.*w8;
      w13 = B_2.*sigma_3;
      w14 = alpha.*w13;
      w15 = kappa_2.*w4;
      w16 = 2.*B;
      kappa_4 = kappa_2.*kappa_2;
      w17 = kappa_4.*sigma_2;
      w18 = kappa_2.*sigma_3;
      w19 = B.*w18;
      w20 = kappa_4.*sigma;
      w21 = alpha_2.*sigma_3;
      w22 = B.*w21;
      w23 = alpha.*w6;
      w24 = -B_2.*w23 + w11.*w20 + w17 + 2.*w19 + 4.*w22;
      w9 = -kappa_2.*w8;
      w25 = B.*kappa_4;
      w26 = alpha.*w25;
      w27 = 6.*alpha;
      w28 = sigma_3.*w3;
      w29 = 4.*w12 + w19 + 2.*w22 - 6.*w28;
      w30 = 3.*w13;
      w31 = alpha.*w30 - alpha_2.*kappa_2.*w10 + sigma.*w25;
      alpha_3 = alpha.*alpha_2;
      w32 = B_2.*alpha_3;
      w33 = alpha_3.*sigma_2;
      w34 = B.*alpha_2;
      w35 = 8.*w34;
      w36 = kappa_2.*sigma_2;
      w37 = B.*w36;
      w38 = B.*w5;
      w39 = alpha.*w38;
      w40 = sigma_2.*w0;
      w41 = kappa.*w40;
      w42 = alpha_2.*w36;
      w43 = 4.*B;
      w44 = alpha_3.*sigma_3 + 4.*sigma.*w32 + w33.*w43;
      w45 = 5.*kappa_2;
      w46 = B_2.*w5;
      w1 = B + sigma;
      result1 = kappa.*(w0_2.*w0_2).*w2.*(kappa - sigma).*(kappa + sigma);
      result2 = (w0.*w0_2).*w2.*w7.*(3.*w3 - w4 + w6);
      result3 = -kappa.*w0_2.*(2.*B.*alpha_2.*kappa_2.*sigma - B.*sigma_4.*w11 + B_2.*kappa_2.*sigma_2 + ...
          20.*alpha.*kappa_2.*sigma_3 + 15.*alpha_2.*kappa_2.*sigma_2 - alpha_2.*sigma_4 + 5.*kappa_2.*sigma_4 - sigma_4.*w10 ...
          - 13.*w12 - 16.*w14 - w15.*w16 - w24 - w9);
      result4 = -w0_2.*w7.*(4.*B.*alpha_2.*kappa_2.*sigma - 3.*B.*w15 + 7.*B_2.*alpha.*kappa_2.*sigma + ...
          3.*B_2.*kappa_2.*sigma_2 + 9.*alpha_2.*kappa_2.*sigma_2 - 3.*w17 - w20.*w27 - w26 - w29 - w31);
      result5 = -w41.*(12.*B.*alpha_2.*sigma_2 + 14.*B.*alpha_3.*sigma + 25.*B_2.*w4 - 28.*alpha_2.*w5 - kappa_2.*w35 + ...
          35.*sigma.*w8 - 34.*w15 - 8.*w18 + 8.*w21 + w30 + 13.*w32 + 10.*w33 - 2.*w37 - 8.*w39);
      result6 = -2.*w40.*(8.*w12 + w24 + 2.*w26 - 10.*w28 + w31 - 7.*w34.*w5 - 14.*w42 + w44);
      result7 = w41.*(16.*B.*alpha_2.*sigma_2 - B.*sigma_3.*w27 + 5.*B_2.*alpha.*sigma_2 + 14.*B_2.*alpha_2.*sigma + ...
          B_2.*sigma_3 - B_2.*w3 + 12.*alpha_2.*sigma_3 - sigma_3.*w45 - 13.*w15 - 6.*w37 - 14.*w39 - w46);
      result8 = 2.*sigma_3.*(-B.*w4.*w45 + B_2.*w36 + alpha.*w46 + w14 + w29 - w35.*w5 - 7.*w42 + w44 + w9);
      result9 = -kappa.*sigma_3.*w1.*(B.*alpha_2.*sigma + 5.*alpha_2.*sigma_2 - w16.*w3 - w23 - w36 - w38 - w4.*w43);
      result10 = 2.*sigma_4.*(w1.*w1).*w3;
    end

    function [result1, result2] = turning_sine(sin, kappa, alpha, sigma, beta)
    %TURNING_SINE  Numerator and denominator of sin θ₀ where the curve of folds turns back in μ₀. Returns numerator, denominator.
    %  Source: f = f′ = f_θ₀ = 0. Operations: 47.
      B = beta + 1;
      a_f = sigma.*(B - alpha);
      p = alpha + sigma;
      sin_2 = sin.*sin;
      width = 1 - sin_2;
      w0 = B.*p;
      w1 = sin.*width;
      lean = -a_f.*(sin.*sin_2) + kappa.*p - w0.*w1;
      a_0 = lean.*sigma;
      w2 = sigma.*sin;
      v = kappa + w2;
      a_2 = -v.*w0;
      w3 = alpha.*w2;
      w_line = kappa.*p + w3;
      w4 = (w_line.*w_line).*width;
      c_0 = w3.*w3 - w4;
      l_1 = -alpha.*sin.*v;
      c_2 = l_1.*l_1 + w4;
      q = B + sigma;
      a_1 = B.*p.*sigma - lean.*v - q.*w1.*w_line;
      c_1 = 2.*w3.*l_1;
      result1 = a_0.*c_2 - a_2.*c_0;
      result2 = -a_1.*c_2 + a_2.*c_1;
    end

    function result1 = turning_cosine(sin, sin0, kappa, alpha, sigma, beta)
    %TURNING_COSINE  cos θ cos θ₀ where the curve of folds turns back in μ₀. Needs α > 0. Returns cos cos0. Source: f = f_θ₀ = 0.
    %  Operations: 11.
      p = alpha + sigma;
      w0 = sigma.*sin;
      result1 = alpha.*sin.*(sigma - sin0.*(kappa + w0))./(alpha.*w0 + kappa.*p);
    end

    function [result1, result2] = displacement(cos0, sin0, mu0, kappa, alpha, sigma, beta)
    %DISPLACEMENT  x and y at steady sliding with the spring's angle held at θ₀. Returns x, y. Source: (12), (13) linearized.
    %  Operations: 20.
      w0 = (cos0.*cos0).*sigma;
      w1 = cos0.*sigma.*sin0;
      w2 = alpha + w0;
      determinant = alpha.*beta + alpha.*sigma.*(sin0.*sin0) + beta.*w0 - mu0.*w1 + w2;
      w3 = kappa./determinant;
      result1 = w3.*(mu0 + w1);
      result2 = -w2.*w3;
    end

    function [result1, result2, result3] = pole_quadratic(mu0, alpha, sigma, beta)
    %POLE_QUADRATIC  Coefficients of e0 + e1 T + e2 T², whose roots T = tan θ₀ are the poles. Returns e0, e1, e2. Source:
    %  determinant of the linear model. Operations: 7.
      w0 = beta + 1;
      result1 = w0.*(alpha + sigma);
      result2 = -mu0.*sigma;
      result3 = alpha.*(sigma + w0);
    end

    function result1 = pole_friction(T, alpha, sigma, beta)
    %POLE_FRICTION  μ₀ with a pole at T = tan θ₀. Returns mu0. Source: determinant of the linear model. Operations: 13.
      result1 = ((T.*T).*alpha.*(beta + sigma + 1) + alpha.*beta + alpha + beta.*sigma + sigma)./(T.*sigma);
    end

    function result1 = critical_friction_squared(alpha, sigma, beta)
    %CRITICAL_FRICTION_SQUARED  μ_cr²: for α, μ₀ > 0 there is a pole if and only if μ₀ ≥ μ_cr. Returns mu_cr². Source: article,
    %  Section 3. Operations: 9.
      w0 = beta + 1;
      result1 = 4.*alpha.*w0.*(alpha + sigma).*(sigma + w0)./(sigma.*sigma);
    end

    function result1 = spring_length(x, y, cos0, sin0)
    %SPRING_LENGTH  Length of the inclined spring. Returns L. Source: (6) corrected. Operations: 7.
      base0 = cos0 - x;
      base2 = sin0 - y;
      result1 = sqrt(base0.*base0 + base2.*base2);
    end

    function result1 = friction(vx, mu0, V, d)
    %FRICTION  The friction coefficient at the speed x' of the mass. Returns mu. Source: (10). Operations: 9.
      w0 = V - vx;
      result1 = mu0.*(1 - exp(-d.*abs(w0))).*sign(w0);
    end

    function [result1, result2] = rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d)
    %RHS  Accelerations, kinked where a border is zero. Returns (q_1″, …). Source: (8)–(11). Operations: 39.
      w1 = cos0 - x;
      w3 = sin0 - y;
      l1 = sqrt(w1.*w1 + w3.*w3);
      w0 = 1./l1;
      c1 = w0.*w1;
      w2 = V - vx;
      side = sign(w2);
      mu = mu0.*side.*(1 - exp(-d.*side.*w2));
      below = 1 - sign(y);
      nbar = below./2;
      s1 = w0.*w3;
      result1 = -c1.*sigma + cos0.*sigma - mu.*nbar.*y - x.*(alpha + sigma);
      result2 = -kappa - s1.*sigma + sigma.*sin0 - y.*(beta + nbar + sigma);
    end

    function [result1, result2] = regime_rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
    %REGIME_RHS  Accelerations in a smooth regime, continued beyond its borders. Returns (q_1″, …). Source: (8)–(10). Operations:
    %  35.
      w1 = cos0 - x;
      w2 = sin0 - y;
      l1 = sqrt(w1.*w1 + w2.*w2);
      w0 = 1./l1;
      c1 = w0.*w1;
      mu = mu0.*side.*(1 - exp(-d.*side.*(V - vx)));
      s1 = w0.*w2;
      result1 = -c1.*sigma + cos0.*sigma - mu.*nbar.*y - x.*(alpha + sigma);
      result2 = -kappa - s1.*sigma + sigma.*sin0 - y.*(beta + nbar + sigma);
    end

    function [result1, result2, result3, result4, result5, result6, result7, result8] = regime_jacobian(x, y, vx, vy, cos0, ...
        sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
    %REGIME_JACOBIAN  Derivatives of regime_rhs by the coordinates and the rates. Returns ((∂q_1″/∂q_1, …, ∂q_1″/∂v_1, …), …).
    %  Source: (8)–(10). Operations: 40.
      w1 = sin0 - y;
      w2 = cos0 - x;
      l1 = sqrt(w1.*w1 + w2.*w2);
      w0 = 1./l1;
      s1 = w0.*w1;
      c1 = w0.*w2;
      w3 = exp(-d.*side.*(V - vx));
      mu = mu0.*side.*(1 - w3);
      w4 = c1.*s1.*sigma.*w0;
      result1 = -alpha + sigma.*((s1.*s1).*w0 - 1);
      result2 = -mu.*nbar - w4;
      result3 = d.*mu0.*nbar.*w3.*y;
      result4 = 0;
      result5 = -w4;
      result6 = -beta - nbar + sigma.*((c1.*c1).*w0 - 1);
      result7 = 0;
      result8 = 0;
    end

    function [result1, result2, result3, w1, result5, result6, result7, result8, result9, result10, result11, result12, ...
        result13, w3, result15, result16] = regime_by_parameters(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, ...
        d, nbar, side)
    %REGIME_BY_PARAMETERS  Derivatives of regime_rhs by all parameters, an angle as the angle. Returns ((∂q_1″/∂p_1, …), …).
    %  Source: (8)–(10). Operations: 52.
      w1 = -x;
      w2 = cos0 + w1;
      w3 = -y;
      w4 = sin0 + w3;
      l1 = sqrt(w2.*w2 + w4.*w4);
      w0 = 1./l1;
      c1 = w0.*w2;
      s1 = w0.*w4;
      w5 = -sin0;
      w6 = sin0.*w0;
      w7 = cos0.*w0;
      w8 = c1.*s1;
      w9 = V - vx;
      w10 = exp(-d.*side.*w9);
      w11 = nbar.*y;
      w12 = -cos0;
      w13 = mu0.*w10.*w11;
      result1 = sigma.*((s1.*s1).*w6 + w5 + w7.*w8);
      result2 = side.*w11.*(w10 - 1);
      result3 = 0;
      result5 = -c1 - w12 - x;
      result6 = 0;
      result7 = -d.*w13;
      result8 = -w13.*w9;
      result9 = sigma.*(-(c1.*c1).*w7 - w12 - w6.*w8);
      result10 = 0;
      result11 = -1;
      result12 = 0;
      result13 = -s1 - w5 - y;
      result15 = 0;
      result16 = 0;
    end

    function result1 = energy(x, y, vx, vy, cos0, sin0, kappa, alpha, sigma, beta, nbar)
    %ENERGY  Kinetic and stored energy, applied forces and contact included. Returns energy. Source: (1), (2). Operations: 29.
      base0 = cos0 - x;
      base2 = sin0 - y;
      l1 = sqrt(base0.*base0 + base2.*base2);
      base8 = l1 - 1;
      w0 = (y.*y)./2;
      result1 = alpha.*(x.*x)./2 + (base8.*base8).*sigma./2 + beta.*w0 + kappa.*y + nbar.*w0 + (vx.*vx)./2 + (vy.*vy)./2;
    end

    function result1 = friction_power(y, vx, mu0, V, d, nbar, side)
    %FRICTION_POWER  Rate at which friction changes that energy. Returns power. Source: (8). Operations: 12.
      mu = mu0.*side.*(1 - exp(-d.*side.*(V - vx)));
      result1 = -mu.*nbar.*vx.*y;
    end
  end
end
