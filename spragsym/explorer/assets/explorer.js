var explorer=(()=>{var d_=Object.create;var tl=Object.defineProperty;var p_=Object.getOwnPropertyDescriptor;var m_=Object.getOwnPropertyNames;var g_=Object.getPrototypeOf,__=Object.prototype.hasOwnProperty;var Nd=(i,t)=>()=>{try{return t||i((t={exports:{}}).exports,t),t.exports}catch(e){throw t=0,e}},x_=(i,t)=>{for(var e in t)tl(i,e,{get:t[e],enumerable:!0})},Ud=(i,t,e,n)=>{if(t&&typeof t=="object"||typeof t=="function")for(let s of m_(t))!__.call(i,s)&&s!==e&&tl(i,s,{get:()=>t[s],enumerable:!(n=p_(t,s))||n.enumerable});return i};var Fd=(i,t,e)=>(e=i!=null?d_(g_(i)):{},Ud(t||!i||!i.__esModule?tl(e,"default",{value:i,enumerable:!0}):e,i)),y_=i=>Ud(tl({},"__esModule",{value:!0}),i);var Zd=Nd((iT,jd)=>{"use strict";function Jn(i){if(this.size=i|0,this.size<=1||(this.size&this.size-1)!==0)throw new Error("FFT size must be a power of two and bigger than 1");this._csize=i<<1;for(var t=new Array(this.size*2),e=0;e<t.length;e+=2){let l=Math.PI*e/this.size;t[e]=Math.cos(l),t[e+1]=-Math.sin(l)}this.table=t;for(var n=0,s=1;this.size>s;s<<=1)n++;this._width=n%2===0?n-1:n,this._bitrev=new Array(1<<this._width);for(var r=0;r<this._bitrev.length;r++){this._bitrev[r]=0;for(var o=0;o<this._width;o+=2){var a=this._width-o-2;this._bitrev[r]|=(r>>>o&3)<<a}}this._out=null,this._data=null,this._inv=0}jd.exports=Jn;Jn.prototype.fromComplexArray=function(t,e){for(var n=e||new Array(t.length>>>1),s=0;s<t.length;s+=2)n[s>>>1]=t[s];return n};Jn.prototype.createComplexArray=function(){let t=new Array(this._csize);for(var e=0;e<t.length;e++)t[e]=0;return t};Jn.prototype.toComplexArray=function(t,e){for(var n=e||this.createComplexArray(),s=0;s<n.length;s+=2)n[s]=t[s>>>1],n[s+1]=0;return n};Jn.prototype.completeSpectrum=function(t){for(var e=this._csize,n=e>>>1,s=2;s<n;s+=2)t[e-s]=t[s],t[e-s+1]=-t[s+1]};Jn.prototype.transform=function(t,e){if(t===e)throw new Error("Input and output buffers must be different");this._out=t,this._data=e,this._inv=0,this._transform4(),this._out=null,this._data=null};Jn.prototype.realTransform=function(t,e){if(t===e)throw new Error("Input and output buffers must be different");this._out=t,this._data=e,this._inv=0,this._realTransform4(),this._out=null,this._data=null};Jn.prototype.inverseTransform=function(t,e){if(t===e)throw new Error("Input and output buffers must be different");this._out=t,this._data=e,this._inv=1,this._transform4();for(var n=0;n<t.length;n++)t[n]/=this.size;this._out=null,this._data=null};Jn.prototype._transform4=function(){var t=this._out,e=this._csize,n=this._width,s=1<<n,r=e/s<<1,o,a,l=this._bitrev;if(r===4)for(o=0,a=0;o<e;o+=r,a++){let x=l[a];this._singleTransform2(o,x,s)}else for(o=0,a=0;o<e;o+=r,a++){let x=l[a];this._singleTransform4(o,x,s)}var c=this._inv?-1:1,f=this.table;for(s>>=2;s>=2;s>>=2){r=e/s<<1;var h=r>>>2;for(o=0;o<e;o+=r)for(var u=o+h,p=o,m=0;p<u;p+=2,m+=s){let x=p,g=x+h,d=g+h,y=d+h,b=t[x],S=t[x+1],E=t[g],A=t[g+1],_=t[d],T=t[d+1],B=t[y],v=t[y+1],M=b,L=S,I=f[m],D=c*f[m+1],F=E*I-A*D,G=E*D+A*I,k=f[2*m],tt=c*f[2*m+1],V=_*k-T*tt,O=_*tt+T*k,H=f[3*m],Z=c*f[3*m+1],$=B*H-v*Z,Y=B*Z+v*H,it=M+V,st=L+O,ot=M-V,ut=L-O,Nt=F+$,Ht=G+Y,It=c*(F-$),Zt=c*(G-Y),$t=it+Nt,Jt=st+Ht,Re=it-Nt,Me=st-Ht,$e=ot+Zt,Se=ut-It,tn=ot-Zt,fe=ut+It;t[x]=$t,t[x+1]=Jt,t[g]=$e,t[g+1]=Se,t[d]=Re,t[d+1]=Me,t[y]=tn,t[y+1]=fe}}};Jn.prototype._singleTransform2=function(t,e,n){let s=this._out,r=this._data,o=r[e],a=r[e+1],l=r[e+n],c=r[e+n+1],f=o+l,h=a+c,u=o-l,p=a-c;s[t]=f,s[t+1]=h,s[t+2]=u,s[t+3]=p};Jn.prototype._singleTransform4=function(t,e,n){let s=this._out,r=this._data,o=this._inv?-1:1,a=n*2,l=n*3,c=r[e],f=r[e+1],h=r[e+n],u=r[e+n+1],p=r[e+a],m=r[e+a+1],x=r[e+l],g=r[e+l+1],d=c+p,y=f+m,b=c-p,S=f-m,E=h+x,A=u+g,_=o*(h-x),T=o*(u-g),B=d+E,v=y+A,M=b+T,L=S-_,I=d-E,D=y-A,F=b-T,G=S+_;s[t]=B,s[t+1]=v,s[t+2]=M,s[t+3]=L,s[t+4]=I,s[t+5]=D,s[t+6]=F,s[t+7]=G};Jn.prototype._realTransform4=function(){var t=this._out,e=this._csize,n=this._width,s=1<<n,r=e/s<<1,o,a,l=this._bitrev;if(r===4)for(o=0,a=0;o<e;o+=r,a++){let J=l[a];this._singleRealTransform2(o,J>>>1,s>>>1)}else for(o=0,a=0;o<e;o+=r,a++){let J=l[a];this._singleRealTransform4(o,J>>>1,s>>>1)}var c=this._inv?-1:1,f=this.table;for(s>>=2;s>=2;s>>=2){r=e/s<<1;var h=r>>>1,u=h>>>1,p=u>>>1;for(o=0;o<e;o+=r)for(var m=0,x=0;m<=p;m+=2,x+=s){var g=o+m,d=g+u,y=d+u,b=y+u,S=t[g],E=t[g+1],A=t[d],_=t[d+1],T=t[y],B=t[y+1],v=t[b],M=t[b+1],L=S,I=E,D=f[x],F=c*f[x+1],G=A*D-_*F,k=A*F+_*D,tt=f[2*x],V=c*f[2*x+1],O=T*tt-B*V,H=T*V+B*tt,Z=f[3*x],$=c*f[3*x+1],Y=v*Z-M*$,it=v*$+M*Z,st=L+O,ot=I+H,ut=L-O,Nt=I-H,Ht=G+Y,It=k+it,Zt=c*(G-Y),$t=c*(k-it),Jt=st+Ht,Re=ot+It,Me=ut+$t,$e=Nt-Zt;if(t[g]=Jt,t[g+1]=Re,t[d]=Me,t[d+1]=$e,m===0){var Se=st-Ht,tn=ot-It;t[y]=Se,t[y+1]=tn;continue}if(m!==p){var fe=ut,hn=-Nt,je=st,en=-ot,W=-c*$t,Rt=-c*Zt,jt=-c*It,se=-c*Ht,wt=fe+W,Ie=hn+Rt,Vt=je+se,qt=en-jt,N=o+u-m,R=o+h-m;t[N]=wt,t[N+1]=Ie,t[R]=Vt,t[R+1]=qt}}}};Jn.prototype._singleRealTransform2=function(t,e,n){let s=this._out,r=this._data,o=r[e],a=r[e+n],l=o+a,c=o-a;s[t]=l,s[t+1]=0,s[t+2]=c,s[t+3]=0};Jn.prototype._singleRealTransform4=function(t,e,n){let s=this._out,r=this._data,o=this._inv?-1:1,a=n*2,l=n*3,c=r[e],f=r[e+n],h=r[e+a],u=r[e+l],p=c+h,m=c-h,x=f+u,g=o*(f-u),d=p+x,y=m,b=-g,S=p-x,E=m,A=g;s[t]=d,s[t+1]=0,s[t+2]=y,s[t+3]=b,s[t+4]=S,s[t+5]=0,s[t+6]=E,s[t+7]=A}});var X0=Nd(ge=>{"use strict";Object.defineProperty(ge,"__esModule",{value:!0});var H1=Object.prototype.toString;function In(i){let t=H1.call(i);return t.endsWith("Array]")&&!t.includes("Big")}function W1(i,t={}){if(!In(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let s=i[e];for(let r=e+1;r<n;r++)i[r]>s&&(s=i[r]);return s}function X1(i,t={}){if(!In(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let s=i[e];for(let r=e+1;r<n;r++)i[r]<s&&(s=i[r]);return s}function k0(i,t={}){if(In(i)){if(i.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(t.output!==void 0){if(!In(t.output))throw new TypeError("output option must be an array if specified");e=t.output}else e=new Array(i.length);let n=X1(i),s=W1(i);if(n===s)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:r=t.autoMinMax?n:0,max:o=t.autoMinMax?s:1}=t;if(r>=o)throw new RangeError("min option must be smaller than max option");let a=(o-r)/(s-n);for(let l=0;l<i.length;l++)e[l]=(i[l]-n)*a+r;return e}var Th=" ".repeat(2),G0=" ".repeat(4);function q1(){return H0(this)}function H0(i,t={}){let{maxRows:e=15,maxColumns:n=10,maxNumSize:s=8,padMinus:r="auto"}=t;return`${i.constructor.name} {
${Th}[
${G0}${Y1(i,e,n,s,r)}
${Th}]
${Th}rows: ${i.rows}
${Th}columns: ${i.columns}
}`}function Y1(i,t,e,n,s){let{rows:r,columns:o}=i,a=Math.min(r,t),l=Math.min(o,e),c=[];if(s==="auto"){s=!1;t:for(let f=0;f<a;f++)for(let h=0;h<l;h++)if(i.get(f,h)<0){s=!0;break t}}for(let f=0;f<a;f++){let h=[];for(let u=0;u<l;u++)h.push($1(i.get(f,u),n,s));c.push(`${h.join(" ")}`)}return l!==o&&(c[c.length-1]+=` ... ${o-e} more columns`),a!==r&&c.push(`... ${r-t} more rows`),c.join(`
${G0}`)}function $1(i,t,e){return(i>=0&&e?` ${z0(i,t-1)}`:z0(i,t)).padEnd(t)}function z0(i,t){let e=i.toString();if(e.length<=t)return e;let n=i.toFixed(t);if(n.length>t&&(n=i.toFixed(Math.max(0,t-(n.length-t)))),n.length<=t&&!n.startsWith("0.000")&&!n.startsWith("-0.000"))return n;let s=i.toExponential(t);return s.length>t&&(s=i.toExponential(Math.max(0,t-(s.length-t)))),s.slice(0)}function j1(i,t){i.prototype.add=function(n){return typeof n=="number"?this.addS(n):this.addM(n)},i.prototype.addS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)+n);return this},i.prototype.addM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)+n.get(s,r));return this},i.add=function(n,s){return new t(n).add(s)},i.prototype.sub=function(n){return typeof n=="number"?this.subS(n):this.subM(n)},i.prototype.subS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)-n);return this},i.prototype.subM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)-n.get(s,r));return this},i.sub=function(n,s){return new t(n).sub(s)},i.prototype.subtract=i.prototype.sub,i.prototype.subtractS=i.prototype.subS,i.prototype.subtractM=i.prototype.subM,i.subtract=i.sub,i.prototype.mul=function(n){return typeof n=="number"?this.mulS(n):this.mulM(n)},i.prototype.mulS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)*n);return this},i.prototype.mulM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)*n.get(s,r));return this},i.mul=function(n,s){return new t(n).mul(s)},i.prototype.multiply=i.prototype.mul,i.prototype.multiplyS=i.prototype.mulS,i.prototype.multiplyM=i.prototype.mulM,i.multiply=i.mul,i.prototype.div=function(n){return typeof n=="number"?this.divS(n):this.divM(n)},i.prototype.divS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)/n);return this},i.prototype.divM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)/n.get(s,r));return this},i.div=function(n,s){return new t(n).div(s)},i.prototype.divide=i.prototype.div,i.prototype.divideS=i.prototype.divS,i.prototype.divideM=i.prototype.divM,i.divide=i.div,i.prototype.mod=function(n){return typeof n=="number"?this.modS(n):this.modM(n)},i.prototype.modS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)%n);return this},i.prototype.modM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)%n.get(s,r));return this},i.mod=function(n,s){return new t(n).mod(s)},i.prototype.modulus=i.prototype.mod,i.prototype.modulusS=i.prototype.modS,i.prototype.modulusM=i.prototype.modM,i.modulus=i.mod,i.prototype.and=function(n){return typeof n=="number"?this.andS(n):this.andM(n)},i.prototype.andS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)&n);return this},i.prototype.andM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)&n.get(s,r));return this},i.and=function(n,s){return new t(n).and(s)},i.prototype.or=function(n){return typeof n=="number"?this.orS(n):this.orM(n)},i.prototype.orS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)|n);return this},i.prototype.orM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)|n.get(s,r));return this},i.or=function(n,s){return new t(n).or(s)},i.prototype.xor=function(n){return typeof n=="number"?this.xorS(n):this.xorM(n)},i.prototype.xorS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)^n);return this},i.prototype.xorM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)^n.get(s,r));return this},i.xor=function(n,s){return new t(n).xor(s)},i.prototype.leftShift=function(n){return typeof n=="number"?this.leftShiftS(n):this.leftShiftM(n)},i.prototype.leftShiftS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)<<n);return this},i.prototype.leftShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)<<n.get(s,r));return this},i.leftShift=function(n,s){return new t(n).leftShift(s)},i.prototype.signPropagatingRightShift=function(n){return typeof n=="number"?this.signPropagatingRightShiftS(n):this.signPropagatingRightShiftM(n)},i.prototype.signPropagatingRightShiftS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)>>n);return this},i.prototype.signPropagatingRightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)>>n.get(s,r));return this},i.signPropagatingRightShift=function(n,s){return new t(n).signPropagatingRightShift(s)},i.prototype.rightShift=function(n){return typeof n=="number"?this.rightShiftS(n):this.rightShiftM(n)},i.prototype.rightShiftS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)>>>n);return this},i.prototype.rightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)>>>n.get(s,r));return this},i.rightShift=function(n,s){return new t(n).rightShift(s)},i.prototype.zeroFillRightShift=i.prototype.rightShift,i.prototype.zeroFillRightShiftS=i.prototype.rightShiftS,i.prototype.zeroFillRightShiftM=i.prototype.rightShiftM,i.zeroFillRightShift=i.rightShift,i.prototype.not=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,~this.get(n,s));return this},i.not=function(n){return new t(n).not()},i.prototype.abs=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.abs(this.get(n,s)));return this},i.abs=function(n){return new t(n).abs()},i.prototype.acos=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.acos(this.get(n,s)));return this},i.acos=function(n){return new t(n).acos()},i.prototype.acosh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.acosh(this.get(n,s)));return this},i.acosh=function(n){return new t(n).acosh()},i.prototype.asin=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.asin(this.get(n,s)));return this},i.asin=function(n){return new t(n).asin()},i.prototype.asinh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.asinh(this.get(n,s)));return this},i.asinh=function(n){return new t(n).asinh()},i.prototype.atan=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.atan(this.get(n,s)));return this},i.atan=function(n){return new t(n).atan()},i.prototype.atanh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.atanh(this.get(n,s)));return this},i.atanh=function(n){return new t(n).atanh()},i.prototype.cbrt=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.cbrt(this.get(n,s)));return this},i.cbrt=function(n){return new t(n).cbrt()},i.prototype.ceil=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.ceil(this.get(n,s)));return this},i.ceil=function(n){return new t(n).ceil()},i.prototype.clz32=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.clz32(this.get(n,s)));return this},i.clz32=function(n){return new t(n).clz32()},i.prototype.cos=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.cos(this.get(n,s)));return this},i.cos=function(n){return new t(n).cos()},i.prototype.cosh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.cosh(this.get(n,s)));return this},i.cosh=function(n){return new t(n).cosh()},i.prototype.exp=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.exp(this.get(n,s)));return this},i.exp=function(n){return new t(n).exp()},i.prototype.expm1=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.expm1(this.get(n,s)));return this},i.expm1=function(n){return new t(n).expm1()},i.prototype.floor=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.floor(this.get(n,s)));return this},i.floor=function(n){return new t(n).floor()},i.prototype.fround=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.fround(this.get(n,s)));return this},i.fround=function(n){return new t(n).fround()},i.prototype.log=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.log(this.get(n,s)));return this},i.log=function(n){return new t(n).log()},i.prototype.log1p=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.log1p(this.get(n,s)));return this},i.log1p=function(n){return new t(n).log1p()},i.prototype.log10=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.log10(this.get(n,s)));return this},i.log10=function(n){return new t(n).log10()},i.prototype.log2=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.log2(this.get(n,s)));return this},i.log2=function(n){return new t(n).log2()},i.prototype.round=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.round(this.get(n,s)));return this},i.round=function(n){return new t(n).round()},i.prototype.sign=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.sign(this.get(n,s)));return this},i.sign=function(n){return new t(n).sign()},i.prototype.sin=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.sin(this.get(n,s)));return this},i.sin=function(n){return new t(n).sin()},i.prototype.sinh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.sinh(this.get(n,s)));return this},i.sinh=function(n){return new t(n).sinh()},i.prototype.sqrt=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.sqrt(this.get(n,s)));return this},i.sqrt=function(n){return new t(n).sqrt()},i.prototype.tan=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.tan(this.get(n,s)));return this},i.tan=function(n){return new t(n).tan()},i.prototype.tanh=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.tanh(this.get(n,s)));return this},i.tanh=function(n){return new t(n).tanh()},i.prototype.trunc=function(){for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.set(n,s,Math.trunc(this.get(n,s)));return this},i.trunc=function(n){return new t(n).trunc()},i.pow=function(n,s){return new t(n).pow(s)},i.prototype.pow=function(n){return typeof n=="number"?this.powS(n):this.powM(n)},i.prototype.powS=function(n){for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)**n);return this},i.prototype.powM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let s=0;s<this.rows;s++)for(let r=0;r<this.columns;r++)this.set(s,r,this.get(s,r)**n.get(s,r));return this}}function bi(i,t,e){let n=e?i.rows:i.rows-1;if(t<0||t>n)throw new RangeError("Row index out of range")}function Ei(i,t,e){let n=e?i.columns:i.columns-1;if(t<0||t>n)throw new RangeError("Column index out of range")}function Do(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.columns)throw new RangeError("vector size must be the same as the number of columns");return t}function No(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.rows)throw new RangeError("vector size must be the same as the number of rows");return t}function ud(i,t){if(!In(t))throw new TypeError("row indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.rows)throw new RangeError("row indices are out of range")}function fd(i,t){if(!In(t))throw new TypeError("column indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.columns)throw new RangeError("column indices are out of range")}function ed(i,t,e,n,s){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(Ah("startRow",t),Ah("endRow",e),Ah("startColumn",n),Ah("endColumn",s),t>e||n>s||t<0||t>=i.rows||e<0||e>=i.rows||n<0||n>=i.columns||s<0||s>=i.columns)throw new RangeError("Submatrix indices are out of range")}function Uh(i,t=0){let e=[];for(let n=0;n<i;n++)e.push(t);return e}function Ah(i,t){if(typeof t!="number")throw new TypeError(`${i} must be a number`)}function Lo(i){if(i.isEmpty())throw new Error("Empty matrix has no elements to index")}function Z1(i){let t=Uh(i.rows);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]+=i.get(e,n);return t}function J1(i){let t=Uh(i.columns);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]+=i.get(e,n);return t}function K1(i){let t=0;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t+=i.get(e,n);return t}function Q1(i){let t=Uh(i.rows,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]*=i.get(e,n);return t}function tE(i){let t=Uh(i.columns,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]*=i.get(e,n);return t}function eE(i){let t=1;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t*=i.get(e,n);return t}function nE(i,t,e){let n=i.rows,s=i.columns,r=[];for(let o=0;o<n;o++){let a=0,l=0,c=0;for(let f=0;f<s;f++)c=i.get(o,f)-e[o],a+=c,l+=c*c;t?r.push((l-a*a/s)/(s-1)):r.push((l-a*a/s)/s)}return r}function iE(i,t,e){let n=i.rows,s=i.columns,r=[];for(let o=0;o<s;o++){let a=0,l=0,c=0;for(let f=0;f<n;f++)c=i.get(f,o)-e[o],a+=c,l+=c*c;t?r.push((l-a*a/n)/(n-1)):r.push((l-a*a/n)/n)}return r}function sE(i,t,e){let n=i.rows,s=i.columns,r=n*s,o=0,a=0,l=0;for(let c=0;c<n;c++)for(let f=0;f<s;f++)l=i.get(c,f)-e,o+=l,a+=l*l;return t?(a-o*o/r)/(r-1):(a-o*o/r)/r}function rE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[e])}function oE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[n])}function aE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t)}function lE(i){let t=[];for(let e=0;e<i.rows;e++){let n=0;for(let s=0;s<i.columns;s++)n+=i.get(e,s)**2/(i.columns-1);t.push(Math.sqrt(n))}return t}function cE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[e])}function hE(i){let t=[];for(let e=0;e<i.columns;e++){let n=0;for(let s=0;s<i.rows;s++)n+=i.get(s,e)**2/(i.rows-1);t.push(Math.sqrt(n))}return t}function uE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[n])}function fE(i){let t=i.size-1,e=0;for(let n=0;n<i.columns;n++)for(let s=0;s<i.rows;s++)e+=i.get(s,n)**2/t;return Math.sqrt(e)}function dE(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t)}var Ye=class i{static from1DArray(t,e,n){if(t*e!==n.length)throw new RangeError("data length does not match given dimensions");let r=new St(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)r.set(o,a,n[o*e+a]);return r}static rowVector(t){let e=new St(1,t.length);for(let n=0;n<t.length;n++)e.set(0,n,t[n]);return e}static columnVector(t){let e=new St(t.length,1);for(let n=0;n<t.length;n++)e.set(n,0,t[n]);return e}static zeros(t,e){return new St(t,e)}static ones(t,e){return new St(t,e).fill(1)}static rand(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{random:s=Math.random}=n,r=new St(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)r.set(o,a,s());return r}static randInt(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{min:s=0,max:r=1e3,random:o=Math.random}=n;if(!Number.isInteger(s))throw new TypeError("min must be an integer");if(!Number.isInteger(r))throw new TypeError("max must be an integer");if(s>=r)throw new RangeError("min must be smaller than max");let a=r-s,l=new St(t,e);for(let c=0;c<t;c++)for(let f=0;f<e;f++){let h=s+Math.round(o()*a);l.set(c,f,h)}return l}static eye(t,e,n){e===void 0&&(e=t),n===void 0&&(n=1);let s=Math.min(t,e),r=this.zeros(t,e);for(let o=0;o<s;o++)r.set(o,o,n);return r}static diag(t,e,n){let s=t.length;e===void 0&&(e=s),n===void 0&&(n=e);let r=Math.min(s,e,n),o=this.zeros(e,n);for(let a=0;a<r;a++)o.set(a,a,t[a]);return o}static min(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,s=t.columns,r=new St(n,s);for(let o=0;o<n;o++)for(let a=0;a<s;a++)r.set(o,a,Math.min(t.get(o,a),e.get(o,a)));return r}static max(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,s=t.columns,r=new this(n,s);for(let o=0;o<n;o++)for(let a=0;a<s;a++)r.set(o,a,Math.max(t.get(o,a),e.get(o,a)));return r}static checkMatrix(t){return i.isMatrix(t)?t:new St(t)}static isMatrix(t){return t!=null&&t.klass==="Matrix"}get size(){return this.rows*this.columns}apply(t){if(typeof t!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.call(this,e,n);return this}applyAlongAxis(t,e){if(typeof t!="function")throw new TypeError("callback must be a function");let n=[];switch(e){case"row":{for(let s=0;s<this.rows;s++)n.push(t.call(this,this.getRow(s),s));break}case"column":{for(let s=0;s<this.columns;s++)n.push(t.call(this,this.getColumn(s),s));break}default:throw new Error(`invalid option: ${e}`)}return n}to1DArray(){let t=[];for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.push(this.get(e,n));return t}to2DArray(){let t=[];for(let e=0;e<this.rows;e++){t.push([]);for(let n=0;n<this.columns;n++)t[e].push(this.get(e,n))}return t}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let t=0;t<this.rows;t++)for(let e=0;e<=t;e++)if(this.get(t,e)!==this.get(e,t))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let t=0;t<this.rows;t++)if(this.get(t,t)!==0)return!1;return!0}isEchelonForm(){let t=0,e=0,n=-1,s=!0,r=!1;for(;t<this.rows&&s;){for(e=0,r=!1;e<this.columns&&r===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(r=!0,n=e):(s=!1,r=!0);t++}return s}isReducedEchelonForm(){let t=0,e=0,n=-1,s=!0,r=!1;for(;t<this.rows&&s;){for(e=0,r=!1;e<this.columns&&r===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(r=!0,n=e):(s=!1,r=!0);for(let o=e+1;o<this.rows;o++)this.get(t,o)!==0&&(s=!1);t++}return s}echelonForm(){let t=this.clone(),e=0,n=0;for(;e<t.rows&&n<t.columns;){let s=e;for(let r=e;r<t.rows;r++)t.get(r,n)>t.get(s,n)&&(s=r);if(t.get(s,n)===0)n++;else{t.swapRows(e,s);let r=t.get(e,n);for(let o=n;o<t.columns;o++)t.set(e,o,t.get(e,o)/r);for(let o=e+1;o<t.rows;o++){let a=t.get(o,n)/t.get(e,n);t.set(o,n,0);for(let l=n+1;l<t.columns;l++)t.set(o,l,t.get(o,l)-t.get(e,l)*a)}e++,n++}}return t}reducedEchelonForm(){let t=this.echelonForm(),e=t.columns,n=t.rows,s=n-1;for(;s>=0;)if(t.maxRow(s)===0)s--;else{let r=0,o=!1;for(;r<n&&o===!1;)t.get(s,r)===1?o=!0:r++;for(let a=0;a<s;a++){let l=t.get(a,r);for(let c=r;c<e;c++){let f=t.get(a,c)-l*t.get(s,c);t.set(a,c,f)}}s--}return t}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:n=1}=t;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(n)||n<=0)throw new TypeError("columns must be a positive integer");let s=new St(this.rows*e,this.columns*n);for(let r=0;r<e;r++)for(let o=0;o<n;o++)s.setSubMatrix(this,this.rows*r,this.columns*o);return s}fill(t){for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,t);return this}neg(){return this.mulS(-1)}getRow(t){bi(this,t);let e=[];for(let n=0;n<this.columns;n++)e.push(this.get(t,n));return e}getRowVector(t){return St.rowVector(this.getRow(t))}setRow(t,e){bi(this,t),e=Do(this,e);for(let n=0;n<this.columns;n++)this.set(t,n,e[n]);return this}swapRows(t,e){bi(this,t),bi(this,e);for(let n=0;n<this.columns;n++){let s=this.get(t,n);this.set(t,n,this.get(e,n)),this.set(e,n,s)}return this}getColumn(t){Ei(this,t);let e=[];for(let n=0;n<this.rows;n++)e.push(this.get(n,t));return e}getColumnVector(t){return St.columnVector(this.getColumn(t))}setColumn(t,e){Ei(this,t),e=No(this,e);for(let n=0;n<this.rows;n++)this.set(n,t,e[n]);return this}swapColumns(t,e){Ei(this,t),Ei(this,e);for(let n=0;n<this.rows;n++){let s=this.get(n,t);this.set(n,t,this.get(n,e)),this.set(n,e,s)}return this}addRowVector(t){t=Do(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[n]);return this}subRowVector(t){t=Do(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[n]);return this}mulRowVector(t){t=Do(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[n]);return this}divRowVector(t){t=Do(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[n]);return this}addColumnVector(t){t=No(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[e]);return this}subColumnVector(t){t=No(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[e]);return this}mulColumnVector(t){t=No(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[e]);return this}divColumnVector(t){t=No(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[e]);return this}mulRow(t,e){bi(this,t);for(let n=0;n<this.columns;n++)this.set(t,n,this.get(t,n)*e);return this}mulColumn(t,e){Ei(this,t);for(let n=0;n<this.rows;n++)this.set(n,t,this.get(n,t)*e);return this}max(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)>e[n]&&(e[n]=this.get(n,s));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)>e[s]&&(e[s]=this.get(n,s));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)>e&&(e=this.get(n,s));return e}default:throw new Error(`invalid option: ${t}`)}}maxIndex(){Lo(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)>t&&(t=this.get(n,s),e[0]=n,e[1]=s);return e}min(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)<e[n]&&(e[n]=this.get(n,s));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)<e[s]&&(e[s]=this.get(n,s));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)<e&&(e=this.get(n,s));return e}default:throw new Error(`invalid option: ${t}`)}}minIndex(){Lo(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let s=0;s<this.columns;s++)this.get(n,s)<t&&(t=this.get(n,s),e[0]=n,e[1]=s);return e}maxRow(t){if(bi(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}maxRowIndex(t){bi(this,t),Lo(this);let e=this.get(t,0),n=[t,0];for(let s=1;s<this.columns;s++)this.get(t,s)>e&&(e=this.get(t,s),n[1]=s);return n}minRow(t){if(bi(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}minRowIndex(t){bi(this,t),Lo(this);let e=this.get(t,0),n=[t,0];for(let s=1;s<this.columns;s++)this.get(t,s)<e&&(e=this.get(t,s),n[1]=s);return n}maxColumn(t){if(Ei(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)>e&&(e=this.get(n,t));return e}maxColumnIndex(t){Ei(this,t),Lo(this);let e=this.get(0,t),n=[0,t];for(let s=1;s<this.rows;s++)this.get(s,t)>e&&(e=this.get(s,t),n[0]=s);return n}minColumn(t){if(Ei(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)<e&&(e=this.get(n,t));return e}minColumnIndex(t){Ei(this,t),Lo(this);let e=this.get(0,t),n=[0,t];for(let s=1;s<this.rows;s++)this.get(s,t)<e&&(e=this.get(s,t),n[0]=s);return n}diag(){let t=Math.min(this.rows,this.columns),e=[];for(let n=0;n<t;n++)e.push(this.get(n,n));return e}norm(t="frobenius"){switch(t){case"max":return St.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${t}`)}}cumulativeSum(){let t=0;for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t+=this.get(e,n),this.set(e,n,t);return this}dot(t){i.isMatrix(t)&&(t=t.to1DArray());let e=this.to1DArray();if(e.length!==t.length)throw new RangeError("vectors do not have the same size");let n=0;for(let s=0;s<e.length;s++)n+=e[s]*t[s];return n}mmul(t){t=St.checkMatrix(t);let e=this.rows,n=this.columns,s=t.columns,r=new St(e,s),o=new Float64Array(n);for(let a=0;a<s;a++){for(let l=0;l<n;l++)o[l]=t.get(l,a);for(let l=0;l<e;l++){let c=0;for(let f=0;f<n;f++)c+=this.get(l,f)*o[f];r.set(l,a,c)}}return r}gram(){let t=this.rows,e=this.columns,n=new Float64Array(e*e);for(let r=0;r<t;r++)for(let o=0;o<e;o++){let a=this.get(r,o);if(a===0)continue;let l=o*e;for(let c=o;c<e;c++)n[l+c]+=a*this.get(r,c)}let s=new St(e,e);for(let r=0;r<e;r++){let o=r*e;for(let a=r;a<e;a++){let l=n[o+a];s.set(r,a,l),s.set(a,r,l)}}return s}transposeMultiply(t){if(t=St.checkMatrix(t),this.rows!==t.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,n=t.columns,s=new St(e,n),r=new Float64Array(n);for(let o=0;o<this.rows;o++){for(let a=0;a<n;a++)r[a]=t.get(o,a);for(let a=0;a<e;a++){let l=this.get(o,a);if(l===0)continue;let c=s.data[a];for(let f=0;f<n;f++)c[f]+=l*r[f]}}return s}mmulByTranspose(t){let e=this.rows,n=this.columns;if(t!==void 0&&t.length!==n)throw new RangeError("scale must have one value per column");let s=new St(e,e),r=new Float64Array(n);for(let o=0;o<e;o++){if(t===void 0)for(let a=0;a<n;a++)r[a]=this.get(o,a);else for(let a=0;a<n;a++)r[a]=t[a]*this.get(o,a);for(let a=o;a<e;a++){let l=0;for(let c=0;c<n;c++)l+=this.get(a,c)*r[c];s.set(a,o,l),s.set(o,a,l)}}return s}mpow(t){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(t)||t<0)throw new RangeError("Exponent must be a non-negative integer");let e=St.eye(this.rows),n=this;for(let s=t;s>=1;s/=2)(s&1)!==0&&(e=e.mmul(n)),n=n.mmul(n);return e}strassen2x2(t){t=St.checkMatrix(t);let e=new St(2,2),n=this.get(0,0),s=t.get(0,0),r=this.get(0,1),o=t.get(0,1),a=this.get(1,0),l=t.get(1,0),c=this.get(1,1),f=t.get(1,1),h=(n+c)*(s+f),u=(a+c)*s,p=n*(o-f),m=c*(l-s),x=(n+r)*f,g=(a-n)*(s+o),d=(r-c)*(l+f),y=h+m-x+d,b=p+x,S=u+m,E=h-u+p+g;return e.set(0,0,y),e.set(0,1,b),e.set(1,0,S),e.set(1,1,E),e}strassen3x3(t){t=St.checkMatrix(t);let e=new St(3,3),n=this.get(0,0),s=this.get(0,1),r=this.get(0,2),o=this.get(1,0),a=this.get(1,1),l=this.get(1,2),c=this.get(2,0),f=this.get(2,1),h=this.get(2,2),u=t.get(0,0),p=t.get(0,1),m=t.get(0,2),x=t.get(1,0),g=t.get(1,1),d=t.get(1,2),y=t.get(2,0),b=t.get(2,1),S=t.get(2,2),E=(n+s+r-o-a-f-h)*g,A=(n-o)*(-p+g),_=a*(-u+p+x-g-d-y+S),T=(-n+o+a)*(u-p+g),B=(o+a)*(-u+p),v=n*u,M=(-n+c+f)*(u-m+d),L=(-n+c)*(m-d),I=(c+f)*(-u+m),D=(n+s+r-a-l-c-f)*d,F=f*(-u+m+x-g-d-y+b),G=(-r+f+h)*(g+y-b),k=(r-h)*(g-b),tt=r*y,V=(f+h)*(-y+b),O=(-r+a+l)*(d+y-S),H=(r-l)*(d-S),Z=(a+l)*(-y+S),$=s*x,Y=l*b,it=o*m,st=c*p,ot=h*S,ut=v+tt+$,Nt=E+T+B+v+G+tt+V,Ht=v+M+I+D+tt+O+Z,It=A+_+T+v+tt+O+H,Zt=A+T+B+v+Y,$t=tt+O+H+Z+it,Jt=v+M+L+F+G+k+tt,Re=G+k+tt+V+st,Me=v+M+L+I+ot;return e.set(0,0,ut),e.set(0,1,Nt),e.set(0,2,Ht),e.set(1,0,It),e.set(1,1,Zt),e.set(1,2,$t),e.set(2,0,Jt),e.set(2,1,Re),e.set(2,2,Me),e}mmulStrassen(t){t=St.checkMatrix(t);let e=this.clone(),n=e.rows,s=e.columns,r=t.rows,o=t.columns;s!==r&&console.warn(`Multiplying ${n} x ${s} and ${r} x ${o} matrix: dimensions do not match.`);function a(h,u,p){let m=h.rows,x=h.columns;if(m===u&&x===p)return h;{let g=i.zeros(u,p);return g=g.setSubMatrix(h,0,0),g}}let l=Math.max(n,r),c=Math.max(s,o);e=a(e,l,c),t=a(t,l,c);function f(h,u,p,m){if(p<=512||m<=512)return h.mmul(u);p%2===1&&m%2===1?(h=a(h,p+1,m+1),u=a(u,p+1,m+1)):p%2===1?(h=a(h,p+1,m),u=a(u,p+1,m)):m%2===1&&(h=a(h,p,m+1),u=a(u,p,m+1));let x=parseInt(h.rows/2,10),g=parseInt(h.columns/2,10),d=h.subMatrix(0,x-1,0,g-1),y=u.subMatrix(0,x-1,0,g-1),b=h.subMatrix(0,x-1,g,h.columns-1),S=u.subMatrix(0,x-1,g,u.columns-1),E=h.subMatrix(x,h.rows-1,0,g-1),A=u.subMatrix(x,u.rows-1,0,g-1),_=h.subMatrix(x,h.rows-1,g,h.columns-1),T=u.subMatrix(x,u.rows-1,g,u.columns-1),B=f(i.add(d,_),i.add(y,T),x,g),v=f(i.add(E,_),y,x,g),M=f(d,i.sub(S,T),x,g),L=f(_,i.sub(A,y),x,g),I=f(i.add(d,b),T,x,g),D=f(i.sub(E,d),i.add(y,S),x,g),F=f(i.sub(b,_),i.add(A,T),x,g),G=i.add(B,L);G.sub(I),G.add(F);let k=i.add(M,I),tt=i.add(v,L),V=i.sub(B,v);V.add(M),V.add(D);let O=i.zeros(2*G.rows,2*G.columns);return O=O.setSubMatrix(G,0,0),O=O.setSubMatrix(k,G.rows,0),O=O.setSubMatrix(tt,0,G.columns),O=O.setSubMatrix(V,G.rows,G.columns),O.subMatrix(0,p-1,0,m-1)}return f(e,t,l,c)}scaleRows(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let s=new St(this.rows,this.columns);for(let r=0;r<this.rows;r++){let o=this.getRow(r);o.length>0&&k0(o,{min:e,max:n,output:o}),s.setRow(r,o)}return s}scaleColumns(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let s=new St(this.rows,this.columns);for(let r=0;r<this.columns;r++){let o=this.getColumn(r);o.length&&k0(o,{min:e,max:n,output:o}),s.setColumn(r,o)}return s}flipRows(){let t=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let n=0;n<t;n++){let s=this.get(e,n),r=this.get(e,this.columns-1-n);this.set(e,n,r),this.set(e,this.columns-1-n,s)}return this}flipColumns(){let t=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let n=0;n<t;n++){let s=this.get(n,e),r=this.get(this.rows-1-n,e);this.set(n,e,r),this.set(this.rows-1-n,e,s)}return this}kroneckerProduct(t){t=St.checkMatrix(t);let e=this.rows,n=this.columns,s=t.rows,r=t.columns,o=new St(e*s,n*r);for(let a=0;a<e;a++)for(let l=0;l<n;l++)for(let c=0;c<s;c++)for(let f=0;f<r;f++)o.set(s*a+c,r*l+f,this.get(a,l)*t.get(c,f));return o}kroneckerSum(t){if(t=St.checkMatrix(t),!this.isSquare()||!t.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,n=t.rows,s=this.kroneckerProduct(St.eye(n,n)),r=St.eye(e,e).kroneckerProduct(t);return s.add(r)}transpose(){let t=new St(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.set(n,e,this.get(e,n));return t}sortRows(t=V0){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(t));return this}sortColumns(t=V0){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(t));return this}subMatrix(t,e,n,s){ed(this,t,e,n,s);let r=new St(e-t+1,s-n+1);for(let o=t;o<=e;o++)for(let a=n;a<=s;a++)r.set(o-t,a-n,this.get(o,a));return r}subMatrixRow(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.columns-1),e>n||e<0||e>=this.columns||n<0||n>=this.columns)throw new RangeError("Argument out of range");let s=new St(t.length,n-e+1);for(let r=0;r<t.length;r++)for(let o=e;o<=n;o++){if(t[r]<0||t[r]>=this.rows)throw new RangeError(`Row index out of range: ${t[r]}`);s.set(r,o-e,this.get(t[r],o))}return s}subMatrixColumn(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.rows-1),e>n||e<0||e>=this.rows||n<0||n>=this.rows)throw new RangeError("Argument out of range");let s=new St(n-e+1,t.length);for(let r=0;r<t.length;r++)for(let o=e;o<=n;o++){if(t[r]<0||t[r]>=this.columns)throw new RangeError(`Column index out of range: ${t[r]}`);s.set(o-e,r,this.get(o,t[r]))}return s}setSubMatrix(t,e,n){if(t=St.checkMatrix(t),t.isEmpty())return this;let s=e+t.rows-1,r=n+t.columns-1;ed(this,e,s,n,r);for(let o=0;o<t.rows;o++)for(let a=0;a<t.columns;a++)this.set(e+o,n+a,t.get(o,a));return this}concat(t,e="row"){switch(t=St.checkMatrix(t),e){case"row":{if(this.columns!==t.columns)throw new RangeError("both matrices must have the same number of columns");let n=new St(this.rows+t.rows,this.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,this.rows,0),n}case"column":{if(this.rows!==t.rows)throw new RangeError("both matrices must have the same number of rows");let n=new St(this.rows,this.columns+t.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,0,this.columns),n}default:throw new Error(`invalid option: ${e}`)}}selection(t,e){ud(this,t),fd(this,e);let n=new St(t.length,e.length);for(let s=0;s<t.length;s++){let r=t[s];for(let o=0;o<e.length;o++){let a=e[o];n.set(s,o,this.get(r,a))}}return n}trace(){let t=Math.min(this.rows,this.columns),e=0;for(let n=0;n<t;n++)e+=this.get(n,n);return e}clone(){return this.constructor.copy(this,new St(this.rows,this.columns))}static copy(t,e){for(let[n,s,r]of t.entries())e.set(n,s,r);return e}sum(t){switch(t){case"row":return Z1(this);case"column":return J1(this);case void 0:return K1(this);default:throw new Error(`invalid option: ${t}`)}}product(t){switch(t){case"row":return Q1(this);case"column":return tE(this);case void 0:return eE(this);default:throw new Error(`invalid option: ${t}`)}}mean(t){let e=this.sum(t);switch(t){case"row":{for(let n=0;n<this.rows;n++)e[n]/=this.columns;return e}case"column":{for(let n=0;n<this.columns;n++)e[n]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${t}`)}}variance(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:n=!0,mean:s=this.mean(t)}=e;if(typeof n!="boolean")throw new TypeError("unbiased must be a boolean");switch(t){case"row":{if(!In(s))throw new TypeError("mean must be an array");return nE(this,n,s)}case"column":{if(!In(s))throw new TypeError("mean must be an array");return iE(this,n,s)}case void 0:{if(typeof s!="number")throw new TypeError("mean must be a number");return sE(this,n,s)}default:throw new Error(`invalid option: ${t}`)}}standardDeviation(t,e){typeof t=="object"&&(e=t,t=void 0);let n=this.variance(t,e);if(t===void 0)return Math.sqrt(n);for(let s=0;s<n.length;s++)n[s]=Math.sqrt(n[s]);return n}center(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:n=this.mean(t)}=e;switch(t){case"row":{if(!In(n))throw new TypeError("center must be an array");return rE(this,n),this}case"column":{if(!In(n))throw new TypeError("center must be an array");return oE(this,n),this}case void 0:{if(typeof n!="number")throw new TypeError("center must be a number");return aE(this,n),this}default:throw new Error(`invalid option: ${t}`)}}scale(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let n=e.scale;switch(t){case"row":{if(n===void 0)n=lE(this);else if(!In(n))throw new TypeError("scale must be an array");return cE(this,n),this}case"column":{if(n===void 0)n=hE(this);else if(!In(n))throw new TypeError("scale must be an array");return uE(this,n),this}case void 0:{if(n===void 0)n=fE(this);else if(typeof n!="number")throw new TypeError("scale must be a number");return dE(this,n),this}default:throw new Error(`invalid option: ${t}`)}}toString(t){return H0(this,t)}[Symbol.iterator](){return this.entries()}*entries(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield[t,e,this.get(t,e)]}*values(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield this.get(t,e)}};Ye.prototype.klass="Matrix";typeof Symbol<"u"&&(Ye.prototype[Symbol.for("nodejs.util.inspect.custom")]=q1);function V0(i,t){return i-t}function pE(i){return i.every(t=>typeof t=="number")}Ye.random=Ye.rand;Ye.randomInt=Ye.randInt;Ye.diagonal=Ye.diag;Ye.prototype.diagonal=Ye.prototype.diag;Ye.identity=Ye.eye;Ye.prototype.negate=Ye.prototype.neg;Ye.prototype.tensorProduct=Ye.prototype.kroneckerProduct;var St=class i extends Ye{data;#t(t,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let n=0;n<t;n++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=t,this.columns=e}constructor(t,e){if(super(),i.isMatrix(t))this.#t(t.rows,t.columns),i.copy(t,this);else if(Number.isInteger(t)&&t>=0)this.#t(t,e);else if(In(t)){let n=t;if(t=n.length,e=t?n[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let s=0;s<t;s++){if(n[s].length!==e)throw new RangeError("Inconsistent array dimensions");if(!pE(n[s]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(n[s]))}this.rows=t,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}removeRow(t){return bi(this,t),this.data.splice(t,1),this.rows-=1,this}addRow(t,e){return e===void 0&&(e=t,t=this.rows),bi(this,t,!0),e=Float64Array.from(Do(this,e)),this.data.splice(t,0,e),this.rows+=1,this}removeColumn(t){Ei(this,t);for(let e=0;e<this.rows;e++){let n=new Float64Array(this.columns-1);for(let s=0;s<t;s++)n[s]=this.data[e][s];for(let s=t+1;s<this.columns;s++)n[s-1]=this.data[e][s];this.data[e]=n}return this.columns-=1,this}addColumn(t,e){typeof e>"u"&&(e=t,t=this.columns),Ei(this,t,!0),e=No(this,e);for(let n=0;n<this.rows;n++){let s=new Float64Array(this.columns+1),r=0;for(;r<t;r++)s[r]=this.data[n][r];for(s[r++]=e[n];r<this.columns+1;r++)s[r]=this.data[n][r-1];this.data[n]=s}return this.columns+=1,this}};j1(Ye,St);var Er=class i extends Ye{#t;get size(){return this.#t.size}get rows(){return this.#t.rows}get columns(){return this.#t.columns}get diagonalSize(){return this.rows}static isSymmetricMatrix(t){return St.isMatrix(t)&&t.klassType==="SymmetricMatrix"}static zeros(t){return new this(t)}static ones(t){return new this(t).fill(1)}constructor(t){if(super(),St.isMatrix(t)){if(!t.isSymmetric())throw new TypeError("not symmetric data");this.#t=St.copy(t,new St(t.rows,t.rows))}else if(Number.isInteger(t)&&t>=0)this.#t=new St(t,t);else if(this.#t=new St(t),!this.isSymmetric())throw new TypeError("not symmetric data")}clone(){let t=new i(this.diagonalSize);for(let[e,n,s]of this.upperRightEntries())t.set(e,n,s);return t}toMatrix(){return new St(this)}get(t,e){return this.#t.get(t,e)}set(t,e,n){return this.#t.set(t,e,n),this.#t.set(e,t,n),this}removeCross(t){return this.#t.removeRow(t),this.#t.removeColumn(t),this}addCross(t,e){e===void 0&&(e=t,t=this.diagonalSize);let n=e.slice();return n.splice(t,1),this.#t.addRow(t,n),this.#t.addColumn(t,e),this}applyMask(t){if(t.length!==this.diagonalSize)throw new RangeError("Mask size do not match with matrix size");let e=[];for(let[n,s]of t.entries())s||e.push(n);e.reverse();for(let n of e)this.removeCross(n);return this}toCompact(){let{diagonalSize:t}=this,e=new Array(t*(t+1)/2);for(let n=0,s=0,r=0;r<e.length;r++)e[r]=this.get(s,n),++n>=t&&(n=++s);return e}static fromCompact(t){let e=t.length,n=(Math.sqrt(8*e+1)-1)/2;if(!Number.isInteger(n))throw new TypeError(`This array is not a compact representation of a Symmetric Matrix, ${JSON.stringify(t)}`);let s=new i(n);for(let r=0,o=0,a=0;a<e;a++)s.set(r,o,t[a]),++r>=n&&(r=++o);return s}*upperRightEntries(){for(let t=0,e=0;t<this.diagonalSize;void 0){let n=this.get(t,e);yield[t,e,n],++e>=this.diagonalSize&&(e=++t)}}*upperRightValues(){for(let t=0,e=0;t<this.diagonalSize;void 0)yield this.get(t,e),++e>=this.diagonalSize&&(e=++t)}};Er.prototype.klassType="SymmetricMatrix";var Ph=class i extends Er{static isDistanceMatrix(t){return Er.isSymmetricMatrix(t)&&t.klassSubType==="DistanceMatrix"}constructor(t){if(super(t),!this.isDistance())throw new TypeError("Provided arguments do no produce a distance matrix")}set(t,e,n){return t===e&&(n=0),super.set(t,e,n)}addCross(t,e){return e===void 0&&(e=t,t=this.diagonalSize),e=e.slice(),e[t]=0,super.addCross(t,e)}toSymmetricMatrix(){return new Er(this)}clone(){let t=new i(this.diagonalSize);for(let[e,n,s]of this.upperRightEntries())e!==n&&t.set(e,n,s);return t}toCompact(){let{diagonalSize:t}=this,e=(t-1)*t/2,n=new Array(e);for(let s=1,r=0,o=0;o<n.length;o++)n[o]=this.get(r,s),++s>=t&&(s=++r+1);return n}static fromCompact(t){let e=t.length;if(e===0)return new this(0);let n=(Math.sqrt(8*e+1)+1)/2;if(!Number.isInteger(n))throw new TypeError(`This array is not a compact representation of a DistanceMatrix, ${JSON.stringify(t)}`);let s=new this(n);for(let r=1,o=0,a=0;a<e;a++)s.set(r,o,t[a]),++r>=n&&(r=++o+1);return s}};Ph.prototype.klassSubType="DistanceMatrix";var zi=class extends Ye{constructor(t,e,n){super(),this.matrix=t,this.rows=e,this.columns=n}},nd=class extends zi{constructor(t,e){Ei(t,e),super(t,t.rows,1),this.column=e}set(t,e,n){return this.matrix.set(t,this.column,n),this}get(t){return this.matrix.get(t,this.column)}},id=class extends zi{constructor(t,e){fd(t,e),super(t,t.rows,e.length),this.columnIndices=e}set(t,e,n){return this.matrix.set(t,this.columnIndices[e],n),this}get(t,e){return this.matrix.get(t,this.columnIndices[e])}},sd=class extends zi{constructor(t){super(t,t.rows,t.columns)}set(t,e,n){return this.matrix.set(t,this.columns-e-1,n),this}get(t,e){return this.matrix.get(t,this.columns-e-1)}},rd=class extends zi{constructor(t){super(t,t.rows,t.columns)}set(t,e,n){return this.matrix.set(this.rows-t-1,e,n),this}get(t,e){return this.matrix.get(this.rows-t-1,e)}},od=class extends zi{constructor(t,e){bi(t,e),super(t,1,t.columns),this.row=e}set(t,e,n){return this.matrix.set(this.row,e,n),this}get(t,e){return this.matrix.get(this.row,e)}},ad=class extends zi{constructor(t,e){ud(t,e),super(t,e.length,t.columns),this.rowIndices=e}set(t,e,n){return this.matrix.set(this.rowIndices[t],e,n),this}get(t,e){return this.matrix.get(this.rowIndices[t],e)}},Uo=class extends zi{constructor(t,e,n){ud(t,e),fd(t,n),super(t,e.length,n.length),this.rowIndices=e,this.columnIndices=n}set(t,e,n){return this.matrix.set(this.rowIndices[t],this.columnIndices[e],n),this}get(t,e){return this.matrix.get(this.rowIndices[t],this.columnIndices[e])}},ld=class extends zi{constructor(t,e,n,s,r){ed(t,e,n,s,r),super(t,n-e+1,r-s+1),this.startRow=e,this.startColumn=s}set(t,e,n){return this.matrix.set(this.startRow+t,this.startColumn+e,n),this}get(t,e){return this.matrix.get(this.startRow+t,this.startColumn+e)}},cd=class extends zi{constructor(t){super(t,t.columns,t.rows)}set(t,e,n){return this.matrix.set(e,t,n),this}get(t,e){return this.matrix.get(e,t)}},Ih=class extends Ye{constructor(t,e={}){let{rows:n=1}=e;if(t.length%n!==0)throw new Error("the data length is not divisible by the number of rows");super(),this.rows=n,this.columns=t.length/n,this.data=t}set(t,e,n){let s=this._calculateIndex(t,e);return this.data[s]=n,this}get(t,e){let n=this._calculateIndex(t,e);return this.data[n]}_calculateIndex(t,e){return t*this.columns+e}},Zn=class extends Ye{constructor(t){super(),this.data=t,this.rows=t.length,this.columns=t[0].length}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}};function mE(i,t){if(In(i))return i[0]&&In(i[0])?new Zn(i):new Ih(i,t);throw new Error("the argument is not an array")}var Fo=class{constructor(t){t=Zn.checkMatrix(t);let e=t.clone(),n=e.rows,s=e.columns,r=new Float64Array(n),o=1,a,l,c,f,h,u,p,m,x;for(a=0;a<n;a++)r[a]=a;for(m=new Float64Array(n),l=0;l<s;l++){for(a=0;a<n;a++)m[a]=e.get(a,l);for(a=0;a<n;a++){for(x=Math.min(a,l),h=0,c=0;c<x;c++)h+=e.get(a,c)*m[c];m[a]-=h,e.set(a,l,m[a])}for(f=l,a=l+1;a<n;a++)Math.abs(m[a])>Math.abs(m[f])&&(f=a);if(f!==l){for(c=0;c<s;c++)u=e.get(f,c),e.set(f,c,e.get(l,c)),e.set(l,c,u);p=r[f],r[f]=r[l],r[l]=p,o=-o}if(l<n&&e.get(l,l)!==0)for(a=l+1;a<n;a++)e.set(a,l,e.get(a,l)/e.get(l,l))}this.LU=e,this.pivotVector=r,this.pivotSign=o}isSingular(){let t=this.LU,e=t.columns;for(let n=0;n<e;n++)if(t.get(n,n)===0)return!0;return!1}solve(t){t=St.checkMatrix(t);let e=this.LU;if(e.rows!==t.rows)throw new Error("Invalid matrix dimensions");if(this.isSingular())throw new Error("LU matrix is singular");let s=t.columns,r=t.subMatrixRow(this.pivotVector,0,s-1),o=e.columns,a,l,c;for(c=0;c<o;c++)for(a=c+1;a<o;a++)for(l=0;l<s;l++)r.set(a,l,r.get(a,l)-r.get(c,l)*e.get(a,c));for(c=o-1;c>=0;c--){for(l=0;l<s;l++)r.set(c,l,r.get(c,l)/e.get(c,c));for(a=0;a<c;a++)for(l=0;l<s;l++)r.set(a,l,r.get(a,l)-r.get(c,l)*e.get(a,c))}return r}get determinant(){let t=this.LU;if(!t.isSquare())throw new Error("Matrix must be square");let e=this.pivotSign,n=t.columns;for(let s=0;s<n;s++)e*=t.get(s,s);return e}get lowerTriangularMatrix(){let t=this.LU,e=t.rows,n=t.columns,s=new St(e,n);for(let r=0;r<e;r++)for(let o=0;o<n;o++)r>o?s.set(r,o,t.get(r,o)):r===o?s.set(r,o,1):s.set(r,o,0);return s}get upperTriangularMatrix(){let t=this.LU,e=t.rows,n=t.columns,s=new St(e,n);for(let r=0;r<e;r++)for(let o=0;o<n;o++)r<=o?s.set(r,o,t.get(r,o)):s.set(r,o,0);return s}get pivotPermutationVector(){return Array.from(this.pivotVector)}};function hd(i){let t=i.data,e=i.rows;for(let n=0;n<e;n++){let s=t[n];for(let r=n+1;r<e;r++){let o=s[r];s[r]=t[r][n],t[r][n]=o}}return i}function As(i,t){let e=0;return Math.abs(i)>Math.abs(t)?(e=t/i,Math.abs(i)*Math.sqrt(1+e*e)):t!==0?(e=i/t,Math.abs(t)*Math.sqrt(1+e*e)):0}var $a=class{constructor(t){t=Zn.checkMatrix(t);let e=t.clone(),n=t.rows,s=t.columns,r=new Float64Array(s),o,a,l,c;for(l=0;l<s;l++){let f=0;for(o=l;o<n;o++)f=As(f,e.get(o,l));if(f!==0){for(e.get(l,l)<0&&(f=-f),o=l;o<n;o++)e.set(o,l,e.get(o,l)/f);for(e.set(l,l,e.get(l,l)+1),a=l+1;a<s;a++){for(c=0,o=l;o<n;o++)c+=e.get(o,l)*e.get(o,a);for(c=-c/e.get(l,l),o=l;o<n;o++)e.set(o,a,e.get(o,a)+c*e.get(o,l))}}r[l]=-f}this.QR=e,this.Rdiag=r}solve(t){t=St.checkMatrix(t);let e=this.QR,n=e.rows;if(t.rows!==n)throw new Error("Matrix row dimensions must agree");if(!this.isFullRank())throw new Error("Matrix is rank deficient");let s=t.columns,r=t.clone(),o=e.columns,a,l,c,f;for(c=0;c<o;c++)for(l=0;l<s;l++){for(f=0,a=c;a<n;a++)f+=e.get(a,c)*r.get(a,l);for(f=-f/e.get(c,c),a=c;a<n;a++)r.set(a,l,r.get(a,l)+f*e.get(a,c))}for(c=o-1;c>=0;c--){for(l=0;l<s;l++)r.set(c,l,r.get(c,l)/this.Rdiag[c]);for(a=0;a<c;a++)for(l=0;l<s;l++)r.set(a,l,r.get(a,l)-r.get(c,l)*e.get(a,c))}return r.subMatrix(0,o-1,0,s-1)}isFullRank(){let t=this.QR.columns;for(let e=0;e<t;e++)if(this.Rdiag[e]===0)return!1;return!0}get upperTriangularMatrix(){let t=this.QR,e=t.columns,n=new St(e,e),s,r;for(s=0;s<e;s++)for(r=0;r<e;r++)s<r?n.set(s,r,t.get(s,r)):s===r?n.set(s,r,this.Rdiag[s]):n.set(s,r,0);return n}get orthogonalMatrix(){let t=this.QR,e=t.rows,n=t.columns,s=new St(e,n),r,o,a,l;for(a=n-1;a>=0;a--){for(r=0;r<e;r++)s.set(r,a,0);for(s.set(a,a,1),o=a;o<n;o++)if(t.get(a,a)!==0){for(l=0,r=a;r<e;r++)l+=t.get(r,a)*s.get(r,o);for(l=-l/t.get(a,a),r=a;r<e;r++)s.set(r,o,s.get(r,o)+l*t.get(r,a))}}return s}},er=class{constructor(t,e={}){if(t=Zn.checkMatrix(t),t.isEmpty())throw new Error("Matrix must be non-empty");let n=t.rows,s=t.columns,{computeLeftSingularVectors:r=!0,computeRightSingularVectors:o=!0,autoTranspose:a=!1}=e,l=!!r,c=!!o,f=!1,h;if(n<s)if(!a)console.warn("Computing SVD on a matrix with more columns than rows. Consider enabling autoTranspose"),h=t.transpose();else{h=t.clone(),n=t.columns,s=t.rows,f=!0;let v=l;l=c,c=v}else h=t.transpose();let u=Math.min(n,s),p=Math.min(n+1,s),m=new Float64Array(p),x=new St(u,n),g=new St(s,s),d=new Float64Array(s),y=new Float64Array(n),b=new Float64Array(p);for(let v=0;v<p;v++)b[v]=v;let S=Math.min(n-1,s),E=Math.max(0,Math.min(s-2,n)),A=Math.max(S,E);for(let v=0;v<A;v++){if(v<S){m[v]=0;for(let M=v;M<n;M++)m[v]=As(m[v],h.get(v,M));if(m[v]!==0){h.get(v,v)<0&&(m[v]=-m[v]);for(let M=v;M<n;M++)h.set(v,M,h.get(v,M)/m[v]);h.set(v,v,h.get(v,v)+1)}m[v]=-m[v]}for(let M=v+1;M<s;M++){if(v<S&&m[v]!==0){let L=0;for(let I=v;I<n;I++)L+=h.get(v,I)*h.get(M,I);L=-L/h.get(v,v);for(let I=v;I<n;I++)h.set(M,I,h.get(M,I)+L*h.get(v,I))}d[M]=h.get(M,v)}if(l&&v<S)for(let M=v;M<n;M++)x.set(v,M,h.get(v,M));if(v<E){d[v]=0;for(let M=v+1;M<s;M++)d[v]=As(d[v],d[M]);if(d[v]!==0){d[v+1]<0&&(d[v]=0-d[v]);for(let M=v+1;M<s;M++)d[M]/=d[v];d[v+1]+=1}if(d[v]=-d[v],v+1<n&&d[v]!==0){for(let M=v+1;M<n;M++)y[M]=0;for(let M=v+1;M<n;M++)for(let L=v+1;L<s;L++)y[M]+=d[L]*h.get(L,M);for(let M=v+1;M<s;M++){let L=-d[M]/d[v+1];for(let I=v+1;I<n;I++)h.set(M,I,h.get(M,I)+L*y[I])}}if(c)for(let M=v+1;M<s;M++)g.set(v,M,d[M])}}let _=Math.min(s,n+1);if(S<s&&(m[S]=h.get(S,S)),n<_&&(m[_-1]=0),E+1<_&&(d[E]=h.get(_-1,E)),d[_-1]=0,l){for(let v=S;v<u;v++){for(let M=0;M<n;M++)x.set(v,M,0);x.set(v,v,1)}for(let v=S-1;v>=0;v--)if(m[v]!==0){for(let M=v+1;M<u;M++){let L=0;for(let I=v;I<n;I++)L+=x.get(v,I)*x.get(M,I);L=-L/x.get(v,v);for(let I=v;I<n;I++)x.set(M,I,x.get(M,I)+L*x.get(v,I))}for(let M=v;M<n;M++)x.set(v,M,-x.get(v,M));x.set(v,v,1+x.get(v,v));for(let M=0;M<v-1;M++)x.set(v,M,0)}else{for(let M=0;M<n;M++)x.set(v,M,0);x.set(v,v,1)}}if(c)for(let v=s-1;v>=0;v--){if(v<E&&d[v]!==0)for(let M=v+1;M<s;M++){let L=0;for(let I=v+1;I<s;I++)L+=g.get(v,I)*g.get(M,I);L=-L/g.get(v,v+1);for(let I=v+1;I<s;I++)g.set(M,I,g.get(M,I)+L*g.get(v,I))}for(let M=0;M<s;M++)g.set(v,M,0);g.set(v,v,1)}let T=_-1,B=Number.EPSILON;for(;_>0;){let v,M;for(v=_-2;v>=-1&&v!==-1;v--){let L=Number.MIN_VALUE+B*Math.abs(m[v]+Math.abs(m[v+1]));if(Math.abs(d[v])<=L||Number.isNaN(d[v])){d[v]=0;break}}if(v===_-2)M=4;else{let L;for(L=_-1;L>=v&&L!==v;L--){let I=(L!==_?Math.abs(d[L]):0)+(L!==v+1?Math.abs(d[L-1]):0);if(Math.abs(m[L])<=B*I){m[L]=0;break}}L===v?M=3:L===_-1?M=1:(M=2,v=L)}switch(v++,M){case 1:{let L=d[_-2];d[_-2]=0;for(let I=_-2;I>=v;I--){let D=As(m[I],L),F=m[I]/D,G=L/D;if(m[I]=D,I!==v&&(L=-G*d[I-1],d[I-1]=F*d[I-1]),c)for(let k=0;k<s;k++)D=F*g.get(I,k)+G*g.get(_-1,k),g.set(_-1,k,-G*g.get(I,k)+F*g.get(_-1,k)),g.set(I,k,D)}break}case 2:{let L=d[v-1];d[v-1]=0;for(let I=v;I<_;I++){let D=As(m[I],L),F=m[I]/D,G=L/D;if(m[I]=D,L=-G*d[I],d[I]=F*d[I],l)for(let k=0;k<n;k++)D=F*x.get(I,k)+G*x.get(v-1,k),x.set(v-1,k,-G*x.get(I,k)+F*x.get(v-1,k)),x.set(I,k,D)}break}case 3:{let L=Math.max(Math.abs(m[_-1]),Math.abs(m[_-2]),Math.abs(d[_-2]),Math.abs(m[v]),Math.abs(d[v])),I=m[_-1]/L,D=m[_-2]/L,F=d[_-2]/L,G=m[v]/L,k=d[v]/L,tt=((D+I)*(D-I)+F*F)/2,V=I*F*(I*F),O=0;(tt!==0||V!==0)&&(tt<0?O=0-Math.sqrt(tt*tt+V):O=Math.sqrt(tt*tt+V),O=V/(tt+O));let H=(G+I)*(G-I)+O,Z=G*k;for(let $=v;$<_-1;$++){let Y=As(H,Z);Y===0&&(Y=Number.MIN_VALUE);let it=H/Y,st=Z/Y;if($!==v&&(d[$-1]=Y),H=it*m[$]+st*d[$],d[$]=it*d[$]-st*m[$],Z=st*m[$+1],m[$+1]=it*m[$+1],c)for(let ot=0;ot<s;ot++)Y=it*g.get($,ot)+st*g.get($+1,ot),g.set($+1,ot,-st*g.get($,ot)+it*g.get($+1,ot)),g.set($,ot,Y);if(Y=As(H,Z),Y===0&&(Y=Number.MIN_VALUE),it=H/Y,st=Z/Y,m[$]=Y,H=it*d[$]+st*m[$+1],m[$+1]=-st*d[$]+it*m[$+1],Z=st*d[$+1],d[$+1]=it*d[$+1],l&&$<n-1)for(let ot=0;ot<n;ot++)Y=it*x.get($,ot)+st*x.get($+1,ot),x.set($+1,ot,-st*x.get($,ot)+it*x.get($+1,ot)),x.set($,ot,Y)}d[_-2]=H;break}case 4:{if(m[v]<=0&&(m[v]=m[v]<0?-m[v]:0,c))for(let L=0;L<=T;L++)g.set(v,L,-g.get(v,L));for(;v<T&&!(m[v]>=m[v+1]);){let L=m[v];if(m[v]=m[v+1],m[v+1]=L,c&&v<s-1)for(let I=0;I<s;I++)L=g.get(v+1,I),g.set(v+1,I,g.get(v,I)),g.set(v,I,L);if(l&&v<n-1)for(let I=0;I<n;I++)L=x.get(v+1,I),x.set(v+1,I,x.get(v,I)),x.set(v,I,L);v++}_--;break}}}if(x=x.isSquare()?hd(x):x.transpose(),g=hd(g),f){let v=g;g=x,x=v}this.m=n,this.n=s,this.s=m,this.U=x,this.V=g}solve(t){let e=t,n=this.threshold,s=this.s.length,r=St.zeros(s,s);for(let u=0;u<s;u++)Math.abs(this.s[u])<=n?r.set(u,u,0):r.set(u,u,1/this.s[u]);let o=this.U,a=this.rightSingularVectors,l=a.mmul(r),c=a.rows,f=o.rows,h=St.zeros(c,f);for(let u=0;u<c;u++)for(let p=0;p<f;p++){let m=0;for(let x=0;x<s;x++)m+=l.get(u,x)*o.get(p,x);h.set(u,p,m)}return h.mmul(e)}solveForDiagonal(t){return this.solve(St.diag(t))}inverse(){let t=this.V,e=this.threshold,n=t.rows,s=t.columns,r=new St(n,this.s.length);for(let f=0;f<n;f++)for(let h=0;h<s;h++)Math.abs(this.s[h])>e&&r.set(f,h,t.get(f,h)/this.s[h]);let o=this.U,a=o.rows,l=o.columns,c=new St(n,a);for(let f=0;f<n;f++)for(let h=0;h<a;h++){let u=0;for(let p=0;p<l;p++)u+=r.get(f,p)*o.get(h,p);c.set(f,h,u)}return c}get condition(){return this.s[0]/this.s[Math.min(this.m,this.n)-1]}get norm2(){return this.s[0]}get rank(){let t=Math.max(this.m,this.n)*this.s[0]*Number.EPSILON,e=0,n=this.s;for(let s=0,r=n.length;s<r;s++)n[s]>t&&e++;return e}get diagonal(){return Array.from(this.s)}get threshold(){return Number.EPSILON/2*Math.max(this.m,this.n)*this.s[0]}get leftSingularVectors(){return this.U}get rightSingularVectors(){return this.V}get diagonalMatrix(){return St.diag(this.s)}};function gE(i,t=!1){return i=Zn.checkMatrix(i),t?new er(i).inverse():W0(i,St.eye(i.rows))}function W0(i,t,e=!1){return i=Zn.checkMatrix(i),t=Zn.checkMatrix(t),e?new er(i).solve(t):i.isSquare()?new Fo(i).solve(t):new $a(i).solve(t)}function Ch(i){if(i=St.checkMatrix(i),i.isSquare()){if(i.columns===0)return 1;let t,e,n,s;if(i.columns===2)return t=i.get(0,0),e=i.get(0,1),n=i.get(1,0),s=i.get(1,1),t*s-e*n;if(i.columns===3){let r,o,a;return r=new Uo(i,[1,2],[1,2]),o=new Uo(i,[1,2],[0,2]),a=new Uo(i,[1,2],[0,1]),t=i.get(0,0),e=i.get(0,1),n=i.get(0,2),t*Ch(r)-e*Ch(o)+n*Ch(a)}else return new Fo(i).determinant}else throw Error("determinant can only be calculated for a square matrix")}function _E(i,t){let e=[];for(let n=0;n<i;n++)n!==t&&e.push(n);return e}function xE(i,t,e,n=1e-9,s=1e-9){if(i>s)return new Array(t.rows+1).fill(0);{let r=t.addRow(e,[0]);for(let o=0;o<r.rows;o++)Math.abs(r.get(o,0))<n&&r.set(o,0,0);return r.to1DArray()}}function yE(i,t={}){let{thresholdValue:e=1e-9,thresholdError:n=1e-9}=t;i=St.checkMatrix(i);let s=i.rows,r=new St(s,s);for(let o=0;o<s;o++){let a=St.columnVector(i.getRow(o)),l=i.subMatrixRow(_E(s,o)).transpose(),f=new er(l).solve(a),h=St.abs(a).max()||1,u=St.sub(a,l.mmul(f)).abs().max()/h;r.setRow(o,xE(u,f,o,e,n))}return r}function vE(i,t=Number.EPSILON){if(i=St.checkMatrix(i),i.isEmpty())return i.transpose();let e=new er(i,{autoTranspose:!0}),n=e.leftSingularVectors,s=e.rightSingularVectors,r=e.diagonal,o=t*Math.max(i.rows,i.columns)*r[0];for(let a=0;a<r.length;a++)Math.abs(r[a])>o?r[a]=1/r[a]:r[a]=0;return s.mmul(St.diag(r).mmul(n.transpose()))}function ME(i,t=i,e={}){i=new St(i);let n=!1;if(typeof t=="object"&&!St.isMatrix(t)&&!In(t)?(e=t,t=i,n=!0):t=new St(t),i.rows!==t.rows)throw new TypeError("Both matrices must have the same number of rows");let{center:s=!0}=e;s&&(i=i.center("column"),n||(t=t.center("column")));let r=i.transposeMultiply(t);for(let o=0;o<r.rows;o++)for(let a=0;a<r.columns;a++)r.set(o,a,r.get(o,a)*(1/(i.rows-1)));return r}function SE(i,t=i,e={}){i=new St(i);let n=!1;if(typeof t=="object"&&!St.isMatrix(t)&&!In(t)?(e=t,t=i,n=!0):t=new St(t),i.rows!==t.rows)throw new TypeError("Both matrices must have the same number of rows");let{center:s=!0,scale:r=!0}=e;s&&(i.center("column"),n||t.center("column")),r&&(i.scale("column"),n||t.scale("column"));let o=i.standardDeviation("column",{unbiased:!0}),a=n?o:t.standardDeviation("column",{unbiased:!0}),l=i.transposeMultiply(t);for(let c=0;c<l.rows;c++)for(let f=0;f<l.columns;f++)l.set(c,f,l.get(c,f)*(1/(o[c]*a[f]))*(1/(i.rows-1)));return l}var Lh=class{constructor(t,e={}){let{assumeSymmetric:n=!1}=e;if(t=Zn.checkMatrix(t),!t.isSquare())throw new Error("Matrix is not a square matrix");if(t.isEmpty())throw new Error("Matrix must be non-empty");let s=t.columns,r=new St(s,s),o=new Float64Array(s),a=new Float64Array(s),l=t,c,f,h=!1;if(n?h=!0:h=t.isSymmetric(),h){for(c=0;c<s;c++)for(f=0;f<s;f++)r.set(f,c,l.get(c,f));wE(s,a,o,r),bE(s,a,o,r),hd(r)}else{let u=new St(s,s),p=new Float64Array(s);for(f=0;f<s;f++)for(c=0;c<s;c++)u.set(c,f,l.get(c,f));EE(s,u,p,r),TE(s,a,o,r,u)}this.n=s,this.e=a,this.d=o,this.V=r}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let t=this.n,e=this.e,n=this.d,s=new St(t,t),r,o;for(r=0;r<t;r++){for(o=0;o<t;o++)s.set(r,o,0);s.set(r,r,n[r]),e[r]>0?s.set(r,r+1,e[r]):e[r]<0&&s.set(r,r-1,e[r])}return s}};function wE(i,t,e,n){let s,r,o,a,l,c,f,h;for(l=0;l<i;l++)e[l]=n.get(l,i-1);for(a=i-1;a>0;a--){for(h=0,o=0,c=0;c<a;c++)h=h+Math.abs(e[c]);if(h===0)for(t[a]=e[a-1],l=0;l<a;l++)e[l]=n.get(l,a-1),n.set(l,a,0),n.set(a,l,0);else{for(c=0;c<a;c++)e[c]/=h,o+=e[c]*e[c];for(s=e[a-1],r=Math.sqrt(o),s>0&&(r=-r),t[a]=h*r,o=o-s*r,e[a-1]=s-r,l=0;l<a;l++)t[l]=0;for(l=0;l<a;l++){for(s=e[l],n.set(a,l,s),r=t[l]+n.get(l,l)*s,c=l+1;c<=a-1;c++)r+=n.get(l,c)*e[c],t[c]+=n.get(l,c)*s;t[l]=r}for(s=0,l=0;l<a;l++)t[l]/=o,s+=t[l]*e[l];for(f=s/(o+o),l=0;l<a;l++)t[l]-=f*e[l];for(l=0;l<a;l++){for(s=e[l],r=t[l],c=l;c<=a-1;c++)n.set(l,c,n.get(l,c)-(s*t[c]+r*e[c]));e[l]=n.get(l,a-1),n.set(l,a,0)}}e[a]=o}for(a=0;a<i-1;a++){if(n.set(a,i-1,n.get(a,a)),n.set(a,a,1),o=e[a+1],o!==0){for(c=0;c<=a;c++)e[c]=n.get(a+1,c)/o;for(l=0;l<=a;l++){for(r=0,c=0;c<=a;c++)r+=n.get(a+1,c)*n.get(l,c);for(c=0;c<=a;c++)n.set(l,c,n.get(l,c)-r*e[c])}}for(c=0;c<=a;c++)n.set(a+1,c,0)}for(l=0;l<i;l++)e[l]=n.get(l,i-1),n.set(l,i-1,0);n.set(i-1,i-1,1),t[0]=0}function bE(i,t,e,n){let s,r,o,a,l,c,f,h,u,p,m,x,g,d,y,b;for(o=1;o<i;o++)t[o-1]=t[o];t[i-1]=0;let S=0,E=0,A=Number.EPSILON;for(c=0;c<i;c++){for(E=Math.max(E,Math.abs(e[c])+Math.abs(t[c])),f=c;f<i&&!(Math.abs(t[f])<=A*E);)f++;if(f>c)do{for(s=e[c],h=(e[c+1]-s)/(2*t[c]),u=As(h,1),h<0&&(u=-u),e[c]=t[c]/(h+u),e[c+1]=t[c]*(h+u),p=e[c+1],r=s-e[c],o=c+2;o<i;o++)e[o]-=r;for(S=S+r,h=e[f],m=1,x=m,g=m,d=t[c+1],y=0,b=0,o=f-1;o>=c;o--)for(g=x,x=m,b=y,s=m*t[o],r=m*h,u=As(h,t[o]),t[o+1]=y*u,y=t[o]/u,m=h/u,h=m*e[o]-y*s,e[o+1]=r+y*(m*s+y*e[o]),l=0;l<i;l++)r=n.get(o+1,l),n.set(o+1,l,y*n.get(o,l)+m*r),n.set(o,l,m*n.get(o,l)-y*r);h=-y*b*g*d*t[c]/p,t[c]=y*h,e[c]=m*h}while(Math.abs(t[c])>A*E);e[c]=e[c]+S,t[c]=0}for(o=0;o<i-1;o++){for(l=o,h=e[o],a=o+1;a<i;a++)e[a]<h&&(l=a,h=e[a]);if(l!==o)for(e[l]=e[o],e[o]=h,a=0;a<i;a++)h=n.get(o,a),n.set(o,a,n.get(l,a)),n.set(l,a,h)}}function EE(i,t,e,n){let s=0,r=i-1,o,a,l,c,f,h,u;for(h=s+1;h<=r-1;h++){for(u=0,c=h;c<=r;c++)u=u+Math.abs(t.get(c,h-1));if(u!==0){for(l=0,c=r;c>=h;c--)e[c]=t.get(c,h-1)/u,l+=e[c]*e[c];for(a=Math.sqrt(l),e[h]>0&&(a=-a),l=l-e[h]*a,e[h]=e[h]-a,f=h;f<i;f++){for(o=0,c=r;c>=h;c--)o+=e[c]*t.get(c,f);for(o=o/l,c=h;c<=r;c++)t.set(c,f,t.get(c,f)-o*e[c])}for(c=0;c<=r;c++){for(o=0,f=r;f>=h;f--)o+=e[f]*t.get(c,f);for(o=o/l,f=h;f<=r;f++)t.set(c,f,t.get(c,f)-o*e[f])}e[h]=u*e[h],t.set(h,h-1,u*a)}}for(c=0;c<i;c++)for(f=0;f<i;f++)n.set(c,f,c===f?1:0);for(h=r-1;h>=s+1;h--)if(t.get(h,h-1)!==0){for(c=h+1;c<=r;c++)e[c]=t.get(c,h-1);for(f=h;f<=r;f++){for(a=0,c=h;c<=r;c++)a+=e[c]*n.get(c,f);for(a=a/e[h]/t.get(h,h-1),c=h;c<=r;c++)n.set(c,f,n.get(c,f)+a*e[c])}}}function TE(i,t,e,n,s){let r=i-1,o=0,a=i-1,l=Number.EPSILON,c=0,f=0,h=0,u=0,p=0,m=0,x=0,g=0,d,y,b,S,E,A,_,T,B,v,M,L,I,D,F;for(d=0;d<i;d++)for((d<o||d>a)&&(e[d]=s.get(d,d),t[d]=0),y=Math.max(d-1,0);y<i;y++)f=f+Math.abs(s.get(d,y));for(;r>=o;){for(S=r;S>o&&(m=Math.abs(s.get(S-1,S-1))+Math.abs(s.get(S,S)),m===0&&(m=f),!(Math.abs(s.get(S,S-1))<l*m));)S--;if(S===r)s.set(r,r,s.get(r,r)+c),e[r]=s.get(r,r),t[r]=0,r--,g=0;else if(S===r-1){if(_=s.get(r,r-1)*s.get(r-1,r),h=(s.get(r-1,r-1)-s.get(r,r))/2,u=h*h+_,x=Math.sqrt(Math.abs(u)),s.set(r,r,s.get(r,r)+c),s.set(r-1,r-1,s.get(r-1,r-1)+c),T=s.get(r,r),u>=0){for(x=h>=0?h+x:h-x,e[r-1]=T+x,e[r]=e[r-1],x!==0&&(e[r]=T-_/x),t[r-1]=0,t[r]=0,T=s.get(r,r-1),m=Math.abs(T)+Math.abs(x),h=T/m,u=x/m,p=Math.sqrt(h*h+u*u),h=h/p,u=u/p,y=r-1;y<i;y++)x=s.get(r-1,y),s.set(r-1,y,u*x+h*s.get(r,y)),s.set(r,y,u*s.get(r,y)-h*x);for(d=0;d<=r;d++)x=s.get(d,r-1),s.set(d,r-1,u*x+h*s.get(d,r)),s.set(d,r,u*s.get(d,r)-h*x);for(d=o;d<=a;d++)x=n.get(d,r-1),n.set(d,r-1,u*x+h*n.get(d,r)),n.set(d,r,u*n.get(d,r)-h*x)}else e[r-1]=T+h,e[r]=T+h,t[r-1]=x,t[r]=-x;r=r-2,g=0}else{if(T=s.get(r,r),B=0,_=0,S<r&&(B=s.get(r-1,r-1),_=s.get(r,r-1)*s.get(r-1,r)),g===10){for(c+=T,d=o;d<=r;d++)s.set(d,d,s.get(d,d)-T);m=Math.abs(s.get(r,r-1))+Math.abs(s.get(r-1,r-2)),T=B=.75*m,_=-.4375*m*m}if(g===30&&(m=(B-T)/2,m=m*m+_,m>0)){for(m=Math.sqrt(m),B<T&&(m=-m),m=T-_/((B-T)/2+m),d=o;d<=r;d++)s.set(d,d,s.get(d,d)-m);c+=m,T=B=_=.964}for(g=g+1,E=r-2;E>=S&&(x=s.get(E,E),p=T-x,m=B-x,h=(p*m-_)/s.get(E+1,E)+s.get(E,E+1),u=s.get(E+1,E+1)-x-p-m,p=s.get(E+2,E+1),m=Math.abs(h)+Math.abs(u)+Math.abs(p),h=h/m,u=u/m,p=p/m,!(E===S||Math.abs(s.get(E,E-1))*(Math.abs(u)+Math.abs(p))<l*(Math.abs(h)*(Math.abs(s.get(E-1,E-1))+Math.abs(x)+Math.abs(s.get(E+1,E+1))))));)E--;for(d=E+2;d<=r;d++)s.set(d,d-2,0),d>E+2&&s.set(d,d-3,0);for(b=E;b<=r-1&&(D=b!==r-1,b!==E&&(h=s.get(b,b-1),u=s.get(b+1,b-1),p=D?s.get(b+2,b-1):0,T=Math.abs(h)+Math.abs(u)+Math.abs(p),T!==0&&(h=h/T,u=u/T,p=p/T)),T!==0);b++)if(m=Math.sqrt(h*h+u*u+p*p),h<0&&(m=-m),m!==0){for(b!==E?s.set(b,b-1,-m*T):S!==E&&s.set(b,b-1,-s.get(b,b-1)),h=h+m,T=h/m,B=u/m,x=p/m,u=u/h,p=p/h,y=b;y<i;y++)h=s.get(b,y)+u*s.get(b+1,y),D&&(h=h+p*s.get(b+2,y),s.set(b+2,y,s.get(b+2,y)-h*x)),s.set(b,y,s.get(b,y)-h*T),s.set(b+1,y,s.get(b+1,y)-h*B);for(d=0;d<=Math.min(r,b+3);d++)h=T*s.get(d,b)+B*s.get(d,b+1),D&&(h=h+x*s.get(d,b+2),s.set(d,b+2,s.get(d,b+2)-h*p)),s.set(d,b,s.get(d,b)-h),s.set(d,b+1,s.get(d,b+1)-h*u);for(d=o;d<=a;d++)h=T*n.get(d,b)+B*n.get(d,b+1),D&&(h=h+x*n.get(d,b+2),n.set(d,b+2,n.get(d,b+2)-h*p)),n.set(d,b,n.get(d,b)-h),n.set(d,b+1,n.get(d,b+1)-h*u)}}}if(f!==0){for(r=i-1;r>=0;r--)if(h=e[r],u=t[r],u===0)for(S=r,s.set(r,r,1),d=r-1;d>=0;d--){for(_=s.get(d,d)-h,p=0,y=S;y<=r;y++)p=p+s.get(d,y)*s.get(y,r);if(t[d]<0)x=_,m=p;else if(S=d,t[d]===0?s.set(d,r,_!==0?-p/_:-p/(l*f)):(T=s.get(d,d+1),B=s.get(d+1,d),u=(e[d]-h)*(e[d]-h)+t[d]*t[d],A=(T*m-x*p)/u,s.set(d,r,A),s.set(d+1,r,Math.abs(T)>Math.abs(x)?(-p-_*A)/T:(-m-B*A)/x)),A=Math.abs(s.get(d,r)),l*A*A>1)for(y=d;y<=r;y++)s.set(y,r,s.get(y,r)/A)}else if(u<0)for(S=r-1,Math.abs(s.get(r,r-1))>Math.abs(s.get(r-1,r))?(s.set(r-1,r-1,u/s.get(r,r-1)),s.set(r-1,r,-(s.get(r,r)-h)/s.get(r,r-1))):(F=Rh(0,-s.get(r-1,r),s.get(r-1,r-1)-h,u),s.set(r-1,r-1,F[0]),s.set(r-1,r,F[1])),s.set(r,r-1,0),s.set(r,r,1),d=r-2;d>=0;d--){for(v=0,M=0,y=S;y<=r;y++)v=v+s.get(d,y)*s.get(y,r-1),M=M+s.get(d,y)*s.get(y,r);if(_=s.get(d,d)-h,t[d]<0)x=_,p=v,m=M;else if(S=d,t[d]===0?(F=Rh(-v,-M,_,u),s.set(d,r-1,F[0]),s.set(d,r,F[1])):(T=s.get(d,d+1),B=s.get(d+1,d),L=(e[d]-h)*(e[d]-h)+t[d]*t[d]-u*u,I=(e[d]-h)*2*u,L===0&&I===0&&(L=l*f*(Math.abs(_)+Math.abs(u)+Math.abs(T)+Math.abs(B)+Math.abs(x))),F=Rh(T*p-x*v+u*M,T*m-x*M-u*v,L,I),s.set(d,r-1,F[0]),s.set(d,r,F[1]),Math.abs(T)>Math.abs(x)+Math.abs(u)?(s.set(d+1,r-1,(-v-_*s.get(d,r-1)+u*s.get(d,r))/T),s.set(d+1,r,(-M-_*s.get(d,r)-u*s.get(d,r-1))/T)):(F=Rh(-p-B*s.get(d,r-1),-m-B*s.get(d,r),x,u),s.set(d+1,r-1,F[0]),s.set(d+1,r,F[1]))),A=Math.max(Math.abs(s.get(d,r-1)),Math.abs(s.get(d,r))),l*A*A>1)for(y=d;y<=r;y++)s.set(y,r-1,s.get(y,r-1)/A),s.set(y,r,s.get(y,r)/A)}for(d=0;d<i;d++)if(d<o||d>a)for(y=d;y<i;y++)n.set(d,y,s.get(d,y));for(y=i-1;y>=o;y--)for(d=o;d<=a;d++){for(x=0,b=o;b<=Math.min(y,a);b++)x=x+n.get(d,b)*s.get(b,y);n.set(d,y,x)}}}function Rh(i,t,e,n){let s,r;return Math.abs(e)>Math.abs(n)?(s=n/e,r=e+s*n,[(i+s*t)/r,(t-s*i)/r]):(s=e/n,r=n+s*e,[(s*i+t)/r,(s*t-i)/r])}var Dh=class{constructor(t){if(t=Zn.checkMatrix(t),!t.isSymmetric())throw new Error("Matrix is not symmetric");let e=t,n=e.rows,s=new St(n,n),r=!0,o,a,l;for(a=0;a<n;a++){let c=0;for(l=0;l<a;l++){let f=0;for(o=0;o<l;o++)f+=s.get(l,o)*s.get(a,o);f=(e.get(a,l)-f)/s.get(l,l),s.set(a,l,f),c=c+f*f}for(c=e.get(a,a)-c,r&&=c>0,s.set(a,a,Math.sqrt(Math.max(c,0))),l=a+1;l<n;l++)s.set(a,l,0)}this.L=s,this.positiveDefinite=r}isPositiveDefinite(){return this.positiveDefinite}solve(t){t=Zn.checkMatrix(t);let e=this.L,n=e.rows;if(t.rows!==n)throw new Error("Matrix dimensions do not match");if(this.isPositiveDefinite()===!1)throw new Error("Matrix is not positive definite");let s=t.columns,r=t.clone(),o,a,l;for(l=0;l<n;l++)for(a=0;a<s;a++){for(o=0;o<l;o++)r.set(l,a,r.get(l,a)-r.get(o,a)*e.get(l,o));r.set(l,a,r.get(l,a)/e.get(l,l))}for(l=n-1;l>=0;l--)for(a=0;a<s;a++){for(o=l+1;o<n;o++)r.set(l,a,r.get(l,a)-r.get(o,a)*e.get(o,l));r.set(l,a,r.get(l,a)/e.get(l,l))}return r}get lowerTriangularMatrix(){return this.L}},Nh=class{constructor(t,e={}){t=Zn.checkMatrix(t);let{Y:n}=e,{scaleScores:s=!1,maxIterations:r=1e3,terminationCriteria:o=1e-10}=e,a;if(n){if(In(n)&&typeof n[0]=="number"?n=St.columnVector(n):n=Zn.checkMatrix(n),n.rows!==t.rows)throw new Error("Y should have the same number of rows as X");a=n.getColumnVector(0)}else a=t.getColumnVector(0);let l=1,c,f,h,u;for(let p=0;p<r&&l>o;p++)h=t.transpose().mmul(a).div(a.transpose().mmul(a).get(0,0)),h=h.div(h.norm()),c=t.mmul(h).div(h.transpose().mmul(h).get(0,0)),p>0&&(l=c.clone().sub(u).pow(2).sum()),u=c.clone(),n?(f=n.transpose().mmul(c).div(c.transpose().mmul(c).get(0,0)),f=f.div(f.norm()),a=n.mmul(f).div(f.transpose().mmul(f).get(0,0))):a=c;if(n){let p=t.transpose().mmul(c).div(c.transpose().mmul(c).get(0,0));p=p.div(p.norm());let m=t.clone().sub(c.clone().mmul(p.transpose())),x=a.transpose().mmul(c).div(c.transpose().mmul(c).get(0,0)),g=n.clone().sub(c.clone().mulS(x.get(0,0)).mmul(f.transpose()));this.t=c,this.p=p.transpose(),this.w=h.transpose(),this.q=f,this.u=a,this.s=c.transpose().mmul(c),this.xResidual=m,this.yResidual=g,this.betas=x}else this.w=h.transpose(),this.s=c.transpose().mmul(c).sqrt(),s?this.t=c.clone().div(this.s.get(0,0)):this.t=c,this.xResidual=t.sub(c.mmul(h.transpose()))}};ge.AbstractMatrix=Ye;ge.CHO=Dh;ge.CholeskyDecomposition=Dh;ge.DistanceMatrix=Ph;ge.EVD=Lh;ge.EigenvalueDecomposition=Lh;ge.LU=Fo;ge.LuDecomposition=Fo;ge.Matrix=St;ge.MatrixColumnSelectionView=id;ge.MatrixColumnView=nd;ge.MatrixFlipColumnView=sd;ge.MatrixFlipRowView=rd;ge.MatrixRowSelectionView=ad;ge.MatrixRowView=od;ge.MatrixSelectionView=Uo;ge.MatrixSubView=ld;ge.MatrixTransposeView=cd;ge.NIPALS=Nh;ge.Nipals=Nh;ge.QR=$a;ge.QrDecomposition=$a;ge.SVD=er;ge.SingularValueDecomposition=er;ge.SymmetricMatrix=Er;ge.WrapperMatrix1D=Ih;ge.WrapperMatrix2D=Zn;ge.correlation=SE;ge.covariance=ME;ge.default=St;ge.determinant=Ch;ge.inverse=gE;ge.linearDependencies=yE;ge.pseudoInverse=vE;ge.solve=W0;ge.wrap=mE});var HE={};x_(HE,{start:()=>VE});function v_(i,t,e){let{curves:n,cusps:s}=i.bifurcation_set(t,{n:120}),r=i.flutter_boundary(t,{n:120}),o=i.critical_friction(t);return{curves:n,cusps:s,lowest:o,flutter:r,strips:S_(i,t,n,e)}}function M_({theta0:i,mu0:t},e){let n=[];for(let s=1;s<i.length;s++){let[r,o]=[i[s-1],i[s]];r<e!=o<e&&n.push(t[s-1]+(t[s]-t[s-1])*(e-r)/(o-r))}return n}function S_(i,t,e,n){let s=[];for(let r=0;r<240;r++){let o=Math.PI*(r+.5)/240,a=[0,...e.flatMap(l=>M_(l,o)).filter(l=>l>0&&l<n).sort((l,c)=>l-c),n];for(let l=1;l<a.length;l++){let{count:c}=i.equilibria({...t,theta0:o,mu0:.5*(a[l-1]+a[l])});c>1&&s.push({i:r,low:a[l-1],high:a[l],count:c})}}return{columns:240,found:s}}var Od={stable:0,divergent:1,flutter:2},cs=Array.from({length:140},(i,t)=>Math.sinh(3.5*(2*t/139-1))/Math.sinh(3.5)),Br=i=>Math.min(Math.PI-.001,Math.max(.001,i));function w_(i,t,e){let s={theta0:new Float32Array(19600),theta:new Float32Array(19600),mu0:new Float32Array(19600),kind:new Uint8Array(19600)};for(let c=0;c<140;c++)for(let f=0;f<140;f++){let h=qh(i,t,cs[c],cs[f]);Object.keys(s).forEach(u=>{s[u][c*140+f]=h[u]})}let r=new Uint8Array(19600).fill(1),o=[];for(let c=141;c<19600;c++){let f=c%140?b_(s,c,e):null;f&&(r[c]=0,o.push(...E_(i,t,Math.floor(c/140),c%140,f).flatMap(h=>T_(i,t,h,e))))}let a=(c,f)=>f.from(o,h=>h[c]),l={theta0:a("theta0",Float32Array),theta:a("theta",Float32Array),mu0:a("mu0",Float32Array),kind:a("kind",Uint8Array)};return{nodes:140,...s,coarse:r,fine:l,rulings:R_(i,t)}}function qh(i,t,e,n){let[s,r]=[Math.PI*e,Math.PI*(1+n)],[o,a]=[(r-s)/2,(r+s)/2],c=Math.max(Math.abs(o-Br(o)),Math.abs(a-Br(a)))<.2?i.surface(t,Br(a),Br(o)):null;return{theta0:Br(o),theta:Br(a),mu0:c?c.mu0:NaN,kind:c?Od[c.stability]:0}}function b_({mu0:i,kind:t},e,n){let s=[e-140-1,e-140,e-1,e],[r,o,a,l]=s.map(u=>i[u]),[c,f]=[Math.min(r,o,a,l),Math.max(r,o,a,l)],h=s.some(u=>t[u]!==t[e]);return f>0&&c<n&&(h||f-c>.25*n)?Math.abs(a-r)+Math.abs(l-o)>Math.abs(o-r)+Math.abs(l-a)?"u":"v":null}function E_(i,t,e,n,s){let[r,o]=s==="u"?[e,[cs[n-1],cs[n]]]:[n,[cs[e-1],cs[e]]],a=Array.from({length:11},(l,c)=>{let f=cs[r-1]+(cs[r]-cs[r-1])*c/10;return o.map(h=>s==="u"?qh(i,t,f,h):qh(i,t,h,f))});return a.slice(1).flatMap(([l,c],f)=>{let[h,u]=a[f];return[[h,u,l],[u,c,l]].filter(p=>p.every(m=>!Number.isNaN(m.mu0)))})}function T_(i,t,e,n){let s=({mu0:o})=>o<0||o>n;if(!e.some(s))return e;let r=e.find(o=>!s(o))?.kind??A_(i,t,e,n);return e.map(o=>s(o)?{...o,kind:r}:o)}function A_(i,t,e,n){let s=l=>e.reduce((c,f)=>c+f[l],0)/3,{states:r}=i.equilibria({...t,theta0:s("theta0"),mu0:n/2}),o=({theta:l})=>Math.abs(l-s("theta")),a=r.reduce((l,c)=>l&&o(l)<=o(c)?l:c,null);return a?Od[a.stability]:e[0].kind}function R_(i,t){let e=[];for(let n=15;n<180;n+=15){let s=[];for(let r=1;r<360;r++){let[o,a]=[Math.PI*n/180,Math.PI*r/360],l=i.surface(t,a,o);l?s.push([o,l.mu0,a]):s.length&&(e.push(s),s=[])}e.push(s)}return e}function Bd(i,{id:t,point:e,top:n,what:s}){try{return{id:t,what:s,value:s==="curves"?v_(i,e,n):w_(i,e,n)}}catch(r){return{id:t,what:s,error:String(r.message??r)}}}var C_="//# start",P_=5e3;function kd(i){let t={},e={},n=0,s=!1,r=0,o=c();function a({id:f,what:h,value:u,error:p}){s=!1,clearTimeout(r);let m=t[h];m&&m.id===f&&m.done(u??null,p),l()}function l(){let f=["curves","surface"].find(u=>e[u]);if(!f||s)return;let h=e[f];delete e[f],s=!0,o.thread?(o.thread.postMessage(h),r=setTimeout(()=>{o.thread.terminate(),o=c(),a({...h,error:"Not drawn here: double precision finds no end of it."})},P_)):setTimeout(()=>a(Bd(i,h)),0)}function c(){let f={thread:null};try{let h=document.getElementById("code").textContent.split(C_)[0].replace(/^export /gm,""),u=`"use strict";
${document.getElementById("worker").textContent}
${h}
explorer.serve({ equilibria, bifurcation_set, critical_friction, flutter_boundary, surface });`;f.thread=new Worker(URL.createObjectURL(new Blob([u],{type:"text/javascript"}))),f.thread.onmessage=({data:p})=>a(p),f.thread.onerror=p=>{p.preventDefault(),f.thread=null,s=!1,Object.entries(t).forEach(([m,{id:x,point:g,top:d}])=>e[m]={id:x,what:m,point:g,top:d}),l()}}catch{f.thread=null}return f}return(f,h,u,p)=>{n+=1,t[f]={id:n,point:h,top:u,done:p},e[f]={id:n,what:f,point:h,top:u},l()}}var I_=["ink","faint","line","panel","stable","divergent","flutter","three","path","jump","accent"];function hs(){let i=getComputedStyle(document.documentElement);return Object.fromEntries(I_.map(t=>[t,i.getPropertyValue(`--${t}`).trim()]))}function zd(i){matchMedia("(prefers-color-scheme: dark)").addEventListener("change",i)}function el(i,t,e,n){let{theta0:s,mu0:r,kappa:o,alpha:a,sigma:l,beta:c}=t,f=n?1:0,h=(p,m,x,g,d)=>{let[y,b]=i.residuals(Math.cos(e.theta),Math.sin(e.theta),e.L,Math.cos(s),Math.sin(s),r,p,m,x,g,d);return[0-y,0-b]},u=h(0,0,0,0,f);return{spring:h(0,0,l,0,0),ties:h(0,a,0,c,0),preload:h(o,0,0,0,0),normal:[0,u[1]],friction:[u[0],0]}}var Vd=Math.PI/180,$i=i=>i*Vd,Je=i=>i/Vd;function Ns(i){let t=i.trim().replace(/[,٫،，﹐]/g,",").replace(/[．。]/g,".").replace(/[−–]/g,"-").replace(/[\s\u00a0\u202f]+/g," ");return/^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?$/.test(t)?Number(t.replace(",",".")):NaN}function He(i,t=6){return i==null||Number.isNaN(i)?"–":String(Number(i.toPrecision(t))).replace("-","−")}function us(i,t=10){return String(Number(i.toPrecision(t)))}var Yh=({angle:i},t)=>i?$i(t):t,nl=({angle:i},t)=>i?Je(t):t,L_=({name:i,angle:t})=>t?`${i}_deg`:i;function il(i,t,e,n={}){let{low:s=-1/0,high:r=1/0,low_open:o,high_open:a}=n,[l,c]=[nl(i,s),nl(i,r)].map(u=>Number(u.toPrecision(12)));if(!Number.isFinite(t))return`“${e}” is not a number; type one like 0.5 or 0,5`;if((t>l||t===l&&!o)&&(t<c||t===c&&!a))return"";let f=i.angle?" degrees":"",h=Number.isFinite(r)?`between ${l} and ${c}${f}`:`${o?"greater than":"at least"} ${l}${f}`;return`${i.symbol} must be ${h}; ${e} is not`}function Gd(i,t,e,n,s=()=>""){let r=e.map(o);function o(a){let{name:l,symbol:c,meaning:f,low:h,high:u}=a,p=L_(a),m=document.createElement("div");m.className="parameter",m.innerHTML=`<label for="${p}"><b>${c}</b> <span>${f}${a.angle?", degrees":""}</span> <i id="${p}_beside"></i></label>
      <input id="${p}" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${p}_error">
      <input id="${p}_slider" type="range" min="${h}" max="${u}" step="any" aria-label="${f}">
      <p class="error" id="${p}_error" role="alert"></p>`,i.append(m);let[x,g,d,y]=["input[type=text]","input[type=range]",".error","i"].map(v=>m.querySelector(v)),b="",S=null;function E(v){d.textContent=v,x.setAttribute("aria-invalid",String(!!v))}function A(){let v=Ns(x.value),M=il(a,v,x.value,n[l]);b=x.value,E(M),M||(S??=t.get(),t.move({[l]:Yh(a,v)},S))}let _=()=>{S=null};x.addEventListener("input",A),x.addEventListener("change",()=>{x.value!==b&&A(),_()}),x.addEventListener("blur",_),x.addEventListener("keydown",v=>{let M={ArrowUp:1,ArrowDown:-1}[v.key];if(v.key==="Enter")_();else if(M){v.preventDefault(),_();let L=nl(a,t.get().point[l])+M*(v.shiftKey?10:1)*(u-h)/200;il(a,L,"",n[l])||(t.move({[l]:Yh(a,L)}),B(!0))}});let T=!1;g.addEventListener("input",()=>{T||(T=!0,requestAnimationFrame(()=>{T=!1,t.move({[l]:Yh(a,Number(g.value))})}))});function B(v=!1){let M=nl(a,t.get().point[l]);g.value=M,y.textContent=s(l,t.get().point[l]),g.setAttribute("aria-valuetext",us(M,5)),(v||document.activeElement!==x&&Ns(x.value)!==M)&&(b=x.value=us(M),_(),E(""))}return B}return a=>r.forEach(l=>l(a))}function $h(i){return(t,e)=>{let n=i?.parameters[t];return n?`${n[0]} = ${He(e*n[1],5)} ${n[2]}`:""}}function Hd(i,t){return Object.entries(i).filter(([,n])=>n!==null).map(([n,s])=>t.includes(n)?[`${n}_deg`,Je(s)]:[n,s]).map(([n,s])=>`${n}=${us(s,15)}`).join("&")}function Wd(i,t,e){let n=new URLSearchParams(i.replace(/^#/,"")),s={};for(let[o,a]of n){let l=Ns(a);Number.isFinite(l)&&(s[o.endsWith("_deg")?o.slice(0,-4):o]=o.endsWith("_deg")?$i(l):l)}let r=Object.fromEntries(t.filter(o=>Object.hasOwn(s,o)&&D_(s[o],e[o])).map(o=>[o,s[o]]));return Object.keys(r).length?r:null}function D_(i,{low:t=-1/0,high:e=1/0,low_open:n,high_open:s}={}){return(n?i>t:i>=t)&&(s?i<e:i<=e)}async function Xd(i,t){let e=`${location.href.split("#")[0]}#${i}`;history.replaceState(null,"",e);try{await navigator.clipboard.writeText(e),t.textContent="The link is copied."}catch{t.textContent="The address now carries the state: copy it from there."}}var N_="http://www.w3.org/2000/svg",[zr,Us,Fs]=[150,300,250],[rr,or]=[64,44],sl=[["spring","S"],["preload","κ"],["normal","n"],["friction","μ₀n"]],[kr,rl,jh]=[640,300,20],qd=1e3,Yd=i=>Math.max(-qd,Math.min(qd,i||0)),Xo=(i,t)=>[Us+zr*Yd(i),Fs-zr*Yd(t)];function an(i,t,e={}){let n=document.createElementNS(N_,t);return Object.entries(e).forEach(([s,r])=>n.setAttribute(s,r)),i.append(n),n}function Zh([i,t],[e,n],s=9,r=7){let o=Math.hypot(e-i,n-t)||1,[a,l]=[(e-i)/o,(n-t)/o],c=[[i,t]];for(let f=0;f<2*s;f++){let[h,u]=[.15+.7*(f+.5)/(2*s),(f%2?1:-1)*r];c.push([i+h*(e-i)-u*l,t+h*(n-t)+u*a])}return c.splice(1,0,[i+.15*(e-i),t+.15*(n-t)]),c.push([i+.85*(e-i),t+.85*(n-t)],[e,n]),c.map(([f,h])=>`${f.toFixed(1)},${h.toFixed(1)}`).join(" ")}function $d(i,t,e=1){let n=an(i,"svg",{viewBox:`0 ${jh} ${kr} ${rl}`,role:"group","aria-label":"The mechanism: a mass on a moving belt, leaned on by an inclined spring"}),s=an(n,"defs"),r=an(s,"marker",{id:"tip",viewBox:"0 0 8 8",refX:7,refY:4,markerWidth:7,markerHeight:7,orient:"auto-start-reverse"});an(r,"path",{d:"M0,0 L8,4 L0,8 z",class:"tip"});let o=Fs+or/2;an(n,"rect",{x:-kr,y:o,width:4*kr,height:18,class:"belt"});let a=an(n,"path",{class:"marks",d:""}),l=an(n,"text",{x:560,y:o+40,class:"note"});l.textContent="belt →",an(n,"path",{d:`M8,${Fs-40} v80`,class:"wall"});let c=Array.from({length:e},()=>({arc:an(n,"path",{class:"arc"}),free:an(n,"path",{class:"free"})})),f=an(n,"polyline",{class:"tie"}),h=an(n,"polyline",{class:"tie"}),u=an(n,"g");c.forEach(M=>{M.spring=an(n,"polyline",{class:"spring"})});let p=an(n,"rect",{width:rr,height:or,rx:4,class:"mass",tabindex:0,role:"slider",id:"mass","aria-label":"The mass: drag it, or move it with arrow keys, and let go to see it move from there"}),m=an(n,"circle",{r:4,class:"hub"}),x=Object.fromEntries(sl.map(([M])=>[M,an(n,"path",{class:`force ${M}`,"marker-end":"url(#tip)"})])),g=Object.fromEntries(sl.map(([M,L])=>{let I=an(n,"text",{class:"force-name"});return I.textContent=L,[M,I]}));c.forEach((M,L)=>{let I=L?`anchor_${L+1}`:"anchor";M.anchor=an(n,"circle",{r:11,class:"anchor",tabindex:0,role:"slider",id:I,"aria-valuemin":0,"aria-valuemax":180}),M.text=an(n,"text",{class:"note"})});let d=an(n,"text",{x:12,y:44,class:"note"}),y={x:0,y:0,pins:[]},b=1;function S(M){let L=n.getScreenCTM().inverse(),{x:I,y:D}=new DOMPoint(M.clientX,M.clientY).matrixTransform(L);return[(I-Us)/zr,(Fs-D)/zr]}function E(M,L,I,D=()=>{}){let F=[0,0];M.addEventListener("pointerdown",G=>{let[k,tt]=S(G);F=[L()[0]-k,L()[1]-tt],M.setPointerCapture(G.pointerId),M.focus({preventScroll:!0}),G.preventDefault()}),M.addEventListener("pointermove",G=>{if(M.hasPointerCapture(G.pointerId)){let[k,tt]=S(G);I(k+F[0],tt+F[1])}}),["pointerup","pointercancel"].forEach(G=>M.addEventListener(G,D))}c.forEach(({anchor:M},L)=>{E(M,()=>y.pins[L].at,(I,D)=>y.pins[L].angle!==void 0&&t.anchor(Math.atan2(Math.max(D,1e-4),I-(y.pins[L].from?.[0]??0)),L)),M.addEventListener("keydown",I=>{let D={ArrowLeft:1,ArrowUp:1,ArrowRight:-1,ArrowDown:-1}[I.key];D&&y.pins[L].angle!==void 0&&(I.preventDefault(),t.anchor(y.pins[L].angle+D*(I.shiftKey?5:.5)*Math.PI/180,L))})}),E(p,()=>[y.x,y.y],(M,L)=>t.mass(M,L,!1),()=>t.mass(y.x,y.y,!0)),p.addEventListener("keydown",M=>{let L={ArrowLeft:[-.02,0],ArrowRight:[.02,0],ArrowUp:[0,.02],ArrowDown:[0,-.02]}[M.key];(L||M.key==="Enter"||M.key===" ")&&(M.preventDefault(),t.mass(y.x+(L?.[0]??0),y.y+(L?.[1]??0),!L))});function A({to:M,x:L,y:I,ties:D,others:F=[],forces:G=null,note:k="",kind:tt=""}){y={x:L,y:I,pins:M};let V=Xo(L,I);_(V,tt==="off"||k.startsWith("in motion")?b:1),M.forEach((O,H)=>T(c[H],O,V)),p.setAttribute("aria-valuetext",`x ${He(L,4)}, y ${He(I,4)}`),p.setAttribute("class",`mass ${tt}`),p.setAttribute("x",V[0]-rr/2),p.setAttribute("y",V[1]-or/2),m.setAttribute("cx",V[0]),m.setAttribute("cy",V[1]),f.setAttribute("points",D[0]?Zh([8,V[1]],[V[0]-rr/2,V[1]],12,4):""),h.setAttribute("points",D[1]?Zh([V[0]+20,24],[V[0]+20,V[1]-or/2],8,4):""),d.textContent=k,u.replaceChildren(),F.forEach(O=>{let[H,Z]=Xo(O.x,O.y);an(u,"rect",{x:H-rr/2,y:Z-or/2,width:rr,height:or,rx:4,class:`ghost ${O.word}`})}),B(G,V)}function _([M,L],I){let D=Math.max(I,(Us+rr-M)/Us,(M+rr-Us)/(kr-Us),(Fs+or-L)/(Fs-jh)),F=Number.isFinite(D)?Math.min(20,D>1?Math.ceil(4*D)/4:1):1;F!==b&&(b=F,n.setAttribute("viewBox",`${Us-Us*b} ${Fs+(rl+jh-Fs)-rl*b} ${kr*b} ${rl*b}`))}function T({arc:M,free:L,spring:I,anchor:D,text:F},{at:G,from:k=[0,0],angle:tt,symbol:V},O){let H=Xo(...G);I.setAttribute("points",Zh(H,O)),D.setAttribute("cx",H[0]),D.setAttribute("cy",H[1]),L.setAttribute("d",`M${Xo(...k)} L${H}`);let Z=tt!==void 0;if(D.classList.toggle("fixed",!Z),D.setAttribute("tabindex",Z?0:-1),D.setAttribute("aria-label",Z?`Anchor of the spring: its inclination ${V} in degrees`:"Anchor of a spring"),Z){D.setAttribute("aria-valuenow",Je(tt).toFixed(2));let[$,[Y,it]]=[.25*zr,Xo(...k)];M.setAttribute("d",`M${Y+$},${it} A${$},${$} 0 0 0 ${Y+$*Math.cos(tt)},${it-$*Math.sin(tt)}`),F.textContent=`${V} = ${He(Je(tt),4)}°`;let st=H[0]>500?-14:16;F.setAttribute("text-anchor",st<0?"end":"start"),F.setAttribute("x",H[0]+st),F.setAttribute("y",H[1]-6)}}function B(M,[L,I]){let D=M?Math.max(...sl.map(([F])=>Math.hypot(...M[F]))):0;for(let[F]of sl){let[G,k]=M?M[F]:[0,0],V=(D?Math.hypot(G,k)/D:0)>.03;x[F].setAttribute("d",V?`M${L},${I} l${70*G/D},${-70*k/D}`:""),g[F].setAttribute("x",L+(V?84*G/D:0)-6),g[F].setAttribute("y",I-(V?84*k/D:0)+5),g[F].style.display=V?"":"none"}}function v(M){let L=(M*zr%32+32)%32;a.setAttribute("d",Array.from({length:82},(I,D)=>`M${D*32-kr-32+L},${o+3} l8,12`).join(" "))}return v(0),{draw:A,roll:v}}var Em=Fd(Zd(),1);var U_="uplot",F_="u-hz",O_="u-vt",B_="u-title",k_="u-wrap",z_="u-under",V_="u-over",G_="u-axis",cr="u-off",H_="u-select",W_="u-cursor-x",X_="u-cursor-y",q_="u-cursor-pt",Y_="u-legend",$_="u-live",j_="u-inline",Z_="u-series",J_="u-marker",Jd="u-label",K_="u-value",Yo="width",$o="height";var Kd="bottom",Vr="left",Jh="right",pu="#000",Qd=pu+"0",Kh="mousemove",tp="mousedown",Qh="mouseup",ep="mouseenter",np="mouseleave",ip="dblclick",Q_="resize",tx="scroll",sp="change",hl="dppxchange",mu="--",$r=typeof window<"u",su=$r?document:null,Hr=$r?window:null,ex=$r?navigator:null,Te,ol;function ru(){let i=devicePixelRatio;Te!=i&&(Te=i,ol&&au(sp,ol,ru),ol=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),hr(sp,ol,ru),Hr.dispatchEvent(new CustomEvent(hl)))}function ri(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function ou(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function We(i,t,e){i.style[t]=e+"px"}function Ci(i,t,e,n){let s=su.createElement(i);return t!=null&&ri(s,t),e?.insertBefore(s,n),s}function xi(i,t){return Ci("div",i,t)}var rp=new WeakMap;function ji(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=rp.get(i);r!=o&&(i.style.transform=r,rp.set(i,r),t<0||e<0||t>n||e>s?ri(i,cr):ou(i,cr))}var op=new WeakMap;function ap(i,t,e){let n=t+e,s=op.get(i);n!=s&&(op.set(i,n),i.style.background=t,i.style.borderColor=e)}var lp=new WeakMap;function cp(i,t,e,n){let s=t+""+e,r=lp.get(i);s!=r&&(lp.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var gu={passive:!0},nx={...gu,capture:!0};function hr(i,t,e,n){t.addEventListener(i,e,n?nx:gu)}function au(i,t,e,n){t.removeEventListener(i,e,gu)}$r&&ru();function Pi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:oi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Op(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Bp=i=>i!=null,kp=i=>i!=null&&i>0,dl=Op(Bp),ix=Op(kp);function sx(i,t,e,n=0,s=!1){let r=s?ix:dl,o=s?kp:Bp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let f=i[c];o(f)&&(f<a?a=f:f>l&&(l=f))}return[a??Fe,l??-Fe]}function pl(i,t,e,n){let s=fp(i),r=fp(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?fs:zp,a=s==1?oi:yi,l=r==1?yi:oi,c=a(o(Mn(i))),f=l(o(Mn(t))),h=Wr(e,c),u=Wr(e,f);return e==10&&(c<0&&(h=Oe(h,-c)),f<0&&(u=Oe(u,-f))),n||e==2?(i=h*s,t=u*r):(i=Wp(i,h),t=ml(t,u)),[i,t]}function _u(i,t,e,n){let s=pl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var xu=.1,hp={mode:3,pad:xu},Zo={pad:0,soft:null,mode:0},rx={min:Zo,max:Zo};function ul(i,t,e,n){return gl(e)?up(i,t,e):(Zo.pad=e,Zo.soft=n?0:null,Zo.mode=n?3:0,up(i,t,rx))}function be(i,t){return i??t}function ox(i,t,e){for(t=be(t,0),e=be(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function up(i,t,e){let n=e.min,s=e.max,r=be(n.pad,0),o=be(s.pad,0),a=be(n.hard,-Fe),l=be(s.hard,Fe),c=be(n.soft,Fe),f=be(s.soft,-Fe),h=be(n.mode,0),u=be(s.mode,0),p=t-i,m=fs(p),x=Wn(Mn(i),Mn(t)),g=fs(x),d=Mn(g-m);(p<1e-24||d>10)&&(p=0,(i==0||t==0)&&(p=1e-24,h==2&&c!=Fe&&(r=0),u==2&&f!=-Fe&&(o=0)));let y=p||x||1e3,b=fs(y),S=Wr(10,oi(b)),E=y*(p==0?i==0?.1:1:r),A=Oe(Wp(i-E,S/10),24),_=i>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Fe,T=Wn(a,A<_&&i>=_?_:Ii(_,A)),B=y*(p==0?t==0?.1:1:o),v=Oe(ml(t+B,S/10),24),M=t<=f&&(u==1||u==3&&v>=f||u==2&&v<=f)?f:-Fe,L=Ii(l,v>M&&t<=M?M:Wn(M,v));return T==L&&T==0&&(L=100),[T,L]}var ax=new Intl.NumberFormat($r?ex.language:"en-US"),yu=i=>ax.format(i),ai=Math,cl=ai.PI,Mn=ai.abs,oi=ai.floor,vn=ai.round,yi=ai.ceil,Ii=ai.min,Wn=ai.max,Wr=ai.pow,fp=ai.sign,fs=ai.log10,zp=ai.log2,lx=(i,t=1)=>ai.sinh(i)*t,tu=(i,t=1)=>ai.asinh(i/t),Fe=1/0;function dp(i){return(fs((i^i>>31)-(i>>31))|0)+1}function lu(i,t,e){return Ii(Wn(i,t),e)}function Vp(i){return typeof i=="function"}function ye(i){return Vp(i)?i:()=>i}var cx=()=>{},Gp=i=>i,Hp=(i,t)=>t,hx=i=>null,pp=i=>!0,mp=(i,t)=>i==t,ux=/\.\d*?(?=9{6,}|0{6,})/gm,ur=i=>{if(qp(i)||Bs.has(i))return i;let t=`${i}`,e=t.match(ux);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ur(s)}e${r}`}return Oe(i,n)};function ar(i,t){return ur(Oe(ur(i/t))*t)}function ml(i,t){return ur(yi(ur(i/t))*t)}function Wp(i,t){return ur(oi(ur(i/t))*t)}function Oe(i,t=0){if(qp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return vn(n)/e}var Bs=new Map;function Xp(i){return((""+i).split(".")[1]||"").length}function Ko(i,t,e,n){let s=[],r=n.map(Xp);for(let o=t;o<e;o++){let a=Mn(o),l=Oe(Wr(i,o),a);for(let c=0;c<n.length;c++){let f=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?f:Oe(f,h);s.push(u),Bs.set(u,h)}}return s}var Jo={},vu=[],Xr=[null,null],Os=Array.isArray,qp=Number.isInteger,fx=i=>i===void 0;function gp(i){return typeof i=="string"}function gl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function dx(i){return i!=null&&typeof i=="object"}var px=Object.getPrototypeOf(Uint8Array),Yp="__proto__";function qr(i,t=gl){let e;if(Os(i)){let n=i.find(s=>s!=null);if(Os(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=qr(i[s],t)}else e=i.slice()}else if(i instanceof px)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Yp&&(e[n]=qr(i[n],t))}else e=i;return e}function _n(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Yp&&(gl(i[s])?_n(i[s],qr(n[s])):i[s]=qr(n[s]))}return i}var mx=0,gx=1,_x=2;function xx(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function yx(i,t){if(Sx(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return wx(o[0])||(o=Mx(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let f=0;f<c;f++)e.add(l[f])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let f=a[c],h=Array(s).fill(void 0),u=t?t[o][c]:gx,p=[];for(let m=0;m<f.length;m++){let x=f[m],g=r.get(l[m]);x===null?u!=mx&&(h[g]=x,u==_x&&p.push(g)):h[g]=x}xx(h,p,s),n.push(h)}}return n}var vx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Mx(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Sx(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function wx(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Wn(1,oi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var $p=["January","February","March","April","May","June","July","August","September","October","November","December"],jp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Zp(i){return i.slice(0,3)}var bx=jp.map(Zp),Ex=$p.map(Zp),Tx={MMMM:$p,MMM:Ex,WWWW:jp,WWW:bx};function qo(i){return(i<10?"0":"")+i}function Ax(i){return(i<10?"00":i<100?"0":"")+i}var Rx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>qo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>qo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>qo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>qo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>qo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Ax(i.getMilliseconds())};function Mu(i,t){t=t||Tx;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Rx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Cx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Px(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Cx?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Jp=i=>i%1==0,fl=[1,2,2.5,5],Ix=Ko(10,-32,0,fl),Kp=Ko(10,0,32,fl),Lx=Kp.filter(Jp),lr=Ix.concat(Kp),Su=`
`,Qp="{YYYY}",_p=Su+Qp,tm="{M}/{D}",jo=Su+tm,al=jo+"/{YY}",em="{aa}",Dx="{h}:{mm}",Gr=Dx+em,xp=Su+Gr,yp=":{ss}",Ce=null;function nm(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ko(10,0,3,fl).filter(Jp):Ko(10,-3,0,fl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Qp,Ce,Ce,Ce,Ce,Ce,Ce,1],[s*28,"{MMM}",_p,Ce,Ce,Ce,Ce,Ce,1],[s,tm,_p,Ce,Ce,Ce,Ce,Ce,1],[n,"{h}"+em,al,Ce,jo,Ce,Ce,Ce,1],[e,Gr,al,Ce,jo,Ce,Ce,Ce,1],[t,yp,al+" "+Gr,Ce,jo+" "+Gr,Ce,xp,Ce,1],[i,yp+".{fff}",al+" "+Gr,Ce,jo+" "+Gr,Ce,xp,Ce,1]];function f(h){return(u,p,m,x,g,d)=>{let y=[],b=g>=o,S=g>=r&&g<o,E=h(m),A=Oe(E*i,3),_=eu(E.getFullYear(),b?0:E.getMonth(),S||b?1:E.getDate()),T=Oe(_*i,3);if(S||b){let B=S?g/r:0,v=b?g/o:0,M=A==T?A:Oe(eu(_.getFullYear()+v,_.getMonth()+B,1)*i,3),L=new Date(vn(M/i)),I=L.getFullYear(),D=L.getMonth();for(let F=0;M<=x;F++){let G=eu(I+v*F,D+B*F,1),k=G-h(Oe(G*i,3));M=Oe((+G+k)*i,3),M<=x&&y.push(M)}}else{let B=g>=s?s:g,v=oi(m)-oi(A),M=T+v+ml(A-T,B);y.push(M);let L=h(M),I=L.getHours()+L.getMinutes()/e+L.getSeconds()/n,D=g/n,F=u.axes[p]._space,G=d/F;for(;M=Oe(M+g,i==1?0:3),!(M>x);)if(D>1){let k=oi(Oe(I+D,6))%24,O=h(M).getHours()-k;O>1&&(O=-1),M-=O*n,I=(I+D)%24;let H=y[y.length-1];Oe((M-H)/g,3)*G>=.7&&y.push(M)}else y.push(M)}return y}}return[l,c,f]}var[Nx,Ux,Fx]=nm(1),[Ox,Bx,kx]=nm(.001);Ko(2,-53,53,[1]);function vp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Mp(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,f,h,u,p;return n.map(m=>{let x=i(m),g=x.getFullYear(),d=x.getMonth(),y=x.getDate(),b=x.getHours(),S=x.getMinutes(),E=x.getSeconds(),A=g!=l&&a[2]||d!=c&&a[3]||y!=f&&a[4]||b!=h&&a[5]||S!=u&&a[6]||E!=p&&a[7]||a[1];return l=g,c=d,f=y,h=b,u=S,p=E,A(x)})}}function zx(i,t){let e=Mu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function eu(i,t,e){return new Date(i,t,e)}function Sp(i,t){return t(i)}var Vx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function wp(i,t){return(e,n,s,r)=>r==null?mu:t(i(n))}function Gx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Hx(i,t){return i.series[t].fill(i,t)}var Wx={show:!0,live:!0,isolate:!1,mount:cx,markers:{show:!0,width:2,stroke:Gx,fill:Hx,dash:"solid"},idx:null,idxs:null,values:[]};function Xx(i,t){let e=i.cursor.points,n=xi(),s=e.size(i,t);We(n,Yo,s),We(n,$o,s);let r=s/-2;We(n,"marginLeft",r),We(n,"marginTop",r);let o=e.width(i,t,s);return o&&We(n,"borderWidth",o),n}function qx(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Yx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function $x(i,t){return i.series[t].points.size}var nu=[0,0];function jx(i,t,e){return nu[0]=t,nu[1]=e,nu}function ll(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function iu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Zx={show:!0,x:!0,y:!0,lock:!1,move:jx,points:{one:!1,show:Xx,size:$x,width:0,stroke:Yx,fill:qx},bind:{mousedown:ll,mouseup:ll,click:ll,dblclick:ll,mousemove:iu,mouseleave:iu,mouseenter:iu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},im={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},wu=_n({},im,{filter:Hp}),sm=_n({},wu,{size:10}),rm=_n({},im,{show:!1}),bu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',om="bold "+bu,am=1.5,bp={show:!0,scale:"x",stroke:pu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:om,side:2,grid:wu,ticks:sm,border:rm,font:bu,lineGap:am,rotate:0},Jx="Value",Kx="Time",Ep={show:!0,scale:"x",auto:!1,sorted:1,min:Fe,max:-Fe,idxs:[]};function Qx(i,t,e,n,s){return t.map(r=>r==null?"":yu(r))}function ty(i,t,e,n,s,r,o){let a=[],l=Bs.get(s)||0;e=o?e:Oe(ml(e,s),l);for(let c=e;c<=n;c=Oe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function cu(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?fs:zp,f=oi(c(e));s=Wr(l,f),l==10&&(s=lr[Pi(s,lr)]);let h=e,u=s*l;l==10&&(u=lr[Pi(u,lr)]);do a.push(h),h=h+s,l==10&&!Bs.has(h)&&(h=Oe(h,Bs.get(s))),h>=u&&(s=h,u=s*l,l==10&&(u=lr[Pi(u,lr)]));while(h<=n);return a}function ey(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?cu(i,t,Wn(l,e),n,s):[l],f=n>=0&&e<=0?[0]:[];return(e<-l?cu(i,t,Wn(l,-n),-e,s):[l]).reverse().map(u=>-u).concat(f,c)}var lm=/./,ny=/[12357]/,iy=/[125]/,Tp=/1/,hu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function sy(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,f=l(10,o),h=l(9,o)-f>=c?lm:l(7,o)-f>=c?ny:l(5,o)-f>=c?iy:Tp;if(h==Tp){let u=Mn(l(1,o)-f);if(u<c)return hu(t.slice().reverse(),a.distr,h,yi(c/u)).reverse()}return hu(t,a.distr,h,1)}function ry(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Mn(l(1,o)-l(2,o));return c<a?hu(t.slice().reverse(),3,lm,yi(a/c)).reverse():t}function oy(i,t,e,n){return n==null?mu:t==null?"":yu(t)}var Ap={show:!0,scale:"y",stroke:pu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:om,side:3,grid:wu,ticks:sm,border:rm,font:bu,lineGap:am,rotate:0};function ay(i,t){let e=3+(i||1)*2;return Oe(e*t,3)}function ly(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Mn(o-r),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var Rp={scale:null,auto:!0,sorted:0,min:Fe,max:-Fe},cm=(i,t,e,n,s)=>s,Cp={show:!0,auto:!0,sorted:0,gaps:cm,alpha:1,facets:[_n({},Rp,{scale:"x"}),_n({},Rp,{scale:"y"})]},Pp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:cm,alpha:1,points:{show:ly,filter:null},values:null,min:Fe,max:-Fe,idxs:[],path:null,clip:null};function cy(i,t,e,n,s){return e/10}var hm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},hy=_n({},hm,{time:!1,ori:1}),Ip={};function um(i,t){let e=Ip[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let f=0;f<e.plots.length;f++)e.plots[f]!=s&&e.plots[f].pub(n,s,r,o,a,l,c)}},i!=null&&(Ip[i]=e)),e}var Yr=1,uu=2;function fr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],f=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,p=a.top,m=a.width,x=a.height,g=i.valToPosH,d=i.valToPosV;return f.ori==0?e(s,l,c,f,h,g,d,u,p,m,x,xl,jr,vl,dm,mm):e(s,l,c,f,h,d,g,p,u,x,m,yl,Zr,Au,pm,gm)}function Eu(i,t){let e=0,n=0,s=be(i.bands,vu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function uy(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ds(i,t,e,n,s,r){return fr(i,t,(o,a,l,c,f,h,u,p,m,x,g)=>{let d=o.pxRound,y=c.dir*(c.ori==0?1:-1),b=c.ori==0?jr:Zr,S,E;y==1?(S=e,E=n):(S=n,E=e);let A=d(h(a[S],c,x,p)),_=d(u(l[S],f,g,m)),T=d(h(a[E],c,x,p)),B=d(u(r==1?f.max:f.min,f,g,m)),v=new Path2D(s);return b(v,T,B),b(v,A,B),b(v,A,_),v})}function _l(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?vl:Au,l=e;for(let h=0;h<i.length;h++){let u=i[h];if(u[1]>u[0]){let p=u[0]-l;p>0&&a(o,l,n,p,n+r),l=u[1]}}let c=e+s-l,f=10;c>0&&a(o,l,n-f/2,c,n+r+f)}return o}function fy(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Tu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,u=c;if(s==1)for(;++c<=n&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let p=r(i[h]),m=u==h?p:r(i[u]),x=h-s;p=o<=0&&x>=0&&x<l?r(i[x]):p;let d=u+s;m=o>=0&&d>=0&&d<l?r(i[d]):m,m>=p&&a.push([p,m])}return a}function Lp(i){return i==0?Gp:i==1?vn:t=>ar(t,i)}function fm(i){let t=i==0?xl:yl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,f=0)=>{c==0&&f==0?n(s,r,o,a,l):(c=Ii(c,a/2,l/2),f=Ii(f,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,f),e(s,r,o+l,r,o,f),e(s,r,o,r+a,o,c),s.closePath())}}var xl=(i,t,e)=>{i.moveTo(t,e)},yl=(i,t,e)=>{i.moveTo(e,t)},jr=(i,t,e)=>{i.lineTo(t,e)},Zr=(i,t,e)=>{i.lineTo(e,t)},vl=fm(0),Au=fm(1),dm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},pm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},mm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},gm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function _m(i){return(t,e,n,s,r)=>fr(t,e,(o,a,l,c,f,h,u,p,m,x,g)=>{let{pxRound:d,points:y}=o,b,S;c.ori==0?(b=xl,S=dm):(b=yl,S=pm);let E=Oe(y.width*Te,3),A=(y.size-y.width)/2*Te,_=Oe(A*2,3),T=new Path2D,B=new Path2D,{left:v,top:M,width:L,height:I}=t.bbox;vl(B,v-_,M-_,L+_*2,I+_*2);let D=F=>{if(l[F]!=null){let G=d(h(a[F],c,x,p)),k=d(u(l[F],f,g,m));b(T,G+A,k),S(T,G,k,A,0,cl*2)}};if(r)r.forEach(D);else for(let F=n;F<=s;F++)D(F);return{stroke:E>0?T:null,fill:T,clip:B,flags:Yr|uu}})}function xm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var dy=xm(jr),py=xm(Zr);function ym(i){let t=be(i?.alignGaps,0);return(e,n,s,r)=>fr(e,n,(o,a,l,c,f,h,u,p,m,x,g)=>{[s,r]=dl(l,s,r);let d=o.pxRound,y=I=>d(h(I,c,x,p)),b=I=>d(u(I,f,g,m)),S,E;c.ori==0?(S=jr,E=dy):(S=Zr,E=py);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},T=_.stroke,B=!1;if(r-s>=x*4){let I=$=>e.posToVal($,c.key,!0),D=null,F=null,G,k,tt,V=y(a[A==1?s:r]),O=y(a[s]),H=y(a[r]),Z=I(A==1?O+1:H-1);for(let $=A==1?s:r;$>=s&&$<=r;$+=A){let Y=a[$],st=(A==1?Y<Z:Y>Z)?V:y(Y),ot=l[$];st==V?ot!=null?(k=ot,D==null?(S(T,st,b(k)),G=D=F=k):k<D?D=k:k>F&&(F=k)):ot===null&&(B=!0):(D!=null&&E(T,V,b(D),b(F),b(G),b(k)),ot!=null?(k=ot,S(T,st,b(k)),D=F=G=k):(D=F=null,ot===null&&(B=!0)),V=st,Z=I(V+A))}D!=null&&D!=F&&tt!=V&&E(T,V,b(D),b(F),b(G),b(k))}else for(let I=A==1?s:r;I>=s&&I<=r;I+=A){let D=l[I];D===null?B=!0:D!=null&&S(T,y(a[I]),b(D))}let[M,L]=Eu(e,n);if(o.fill!=null||M!=0){let I=_.fill=new Path2D(T),D=o.fillTo(e,n,o.min,o.max,M),F=b(D),G=y(a[s]),k=y(a[r]);A==-1&&([k,G]=[G,k]),S(I,k,F),S(I,G,F)}if(!o.spanGaps){let I=[];B&&I.push(...Tu(a,l,s,r,A,y,t)),_.gaps=I=o.gaps(e,n,s,r,I),_.clip=_l(I,c.ori,p,m,x,g)}return L!=0&&(_.band=L==2?[ds(e,n,s,r,T,-1),ds(e,n,s,r,T,1)]:ds(e,n,s,r,T,L)),_})}function my(i){let t=be(i.align,1),e=be(i.ascDesc,!1),n=be(i.alignGaps,0),s=be(i.extend,!1);return(r,o,a,l)=>fr(r,o,(c,f,h,u,p,m,x,g,d,y,b)=>{[a,l]=dl(h,a,l);let S=c.pxRound,{left:E,width:A}=r.bbox,_=O=>S(m(O,u,y,g)),T=O=>S(x(O,p,b,d)),B=u.ori==0?jr:Zr,v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},M=v.stroke,L=u.dir*(u.ori==0?1:-1),I=T(h[L==1?a:l]),D=_(f[L==1?a:l]),F=D,G=D;s&&t==-1&&(G=E,B(M,G,I)),B(M,D,I);for(let O=L==1?a:l;O>=a&&O<=l;O+=L){let H=h[O];if(H==null)continue;let Z=_(f[O]),$=T(H);t==1?B(M,Z,I):B(M,F,$),B(M,Z,$),I=$,F=Z}let k=F;s&&t==1&&(k=E+A,B(M,k,I));let[tt,V]=Eu(r,o);if(c.fill!=null||tt!=0){let O=v.fill=new Path2D(M),H=c.fillTo(r,o,c.min,c.max,tt),Z=T(H);B(O,k,Z),B(O,G,Z)}if(!c.spanGaps){let O=[];O.push(...Tu(f,h,a,l,L,_,n));let H=c.width*Te/2,Z=e||t==1?H:-H,$=e||t==-1?-H:H;O.forEach(Y=>{Y[0]+=Z,Y[1]+=$}),v.gaps=O=c.gaps(r,o,a,l,O),v.clip=_l(O,u.ori,g,d,y,b)}return V!=0&&(v.band=V==2?[ds(r,o,a,l,M,-1),ds(r,o,a,l,M,1)]:ds(r,o,a,l,M,V)),v})}function Dp(i,t,e,n,s,r,o=Fe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let f=Mn(i[l]-i[a]);f<c&&(c=f,o=Mn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function gy(i){i=i||Jo;let t=be(i.size,[.6,Fe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=be(t[1],Fe),l=be(t[2],1),c=be(i.disp,Jo),f=be(i.each,p=>{}),{fill:h,stroke:u}=c;return(p,m,x,g)=>fr(p,m,(d,y,b,S,E,A,_,T,B,v,M)=>{let L=d.pxRound,I=e,D=n*Te,F=a*Te,G=l*Te,k,tt;S.ori==0?[k,tt]=r(p,m):[tt,k]=r(p,m);let V=S.dir*(S.ori==0?1:-1),O=S.ori==0?vl:Au,H=S.ori==0?f:(Rt,jt,se,wt,Ie,Vt,qt)=>{f(Rt,jt,se,Ie,wt,qt,Vt)},Z=be(p.bands,vu).find(Rt=>Rt.series[0]==m),$=Z!=null?Z.dir:0,Y=d.fillTo(p,m,d.min,d.max,$),it=L(_(Y,E,M,B)),st,ot,ut,Nt=v,Ht=L(d.width*Te),It=!1,Zt=null,$t=null,Jt=null,Re=null;h!=null&&(Ht==0||u!=null)&&(It=!0,Zt=h.values(p,m,x,g),$t=new Map,new Set(Zt).forEach(Rt=>{Rt!=null&&$t.set(Rt,new Path2D)}),Ht>0&&(Jt=u.values(p,m,x,g),Re=new Map,new Set(Jt).forEach(Rt=>{Rt!=null&&Re.set(Rt,new Path2D)})));let{x0:Me,size:$e}=c;if(Me!=null&&$e!=null){I=1,y=Me.values(p,m,x,g),Me.unit==2&&(y=y.map(se=>p.posToVal(T+se*v,S.key,!0)));let Rt=$e.values(p,m,x,g);$e.unit==2?ot=Rt[0]*v:ot=A(Rt[0],S,v,T)-A(0,S,v,T),Nt=Dp(y,b,A,S,v,T,Nt),ut=Nt-ot+D}else Nt=Dp(y,b,A,S,v,T,Nt),ut=Nt*o+D,ot=Nt-ut;ut<1&&(ut=0),Ht>=ot/2&&(Ht=0),ut<5&&(L=Gp);let Se=ut>0,tn=Nt-ut-(Se?Ht:0);ot=L(lu(tn,G,F)),st=(I==0?ot/2:I==V?0:ot)-I*V*((I==0?D/2:0)+(Se?Ht/2:0));let fe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},hn=It?null:new Path2D,je=null;if(Z!=null)je=p.data[Z.series[1]];else{let{y0:Rt,y1:jt}=c;Rt!=null&&jt!=null&&(b=jt.values(p,m,x,g),je=Rt.values(p,m,x,g))}let en=k*ot,W=tt*ot;for(let Rt=V==1?x:g;Rt>=x&&Rt<=g;Rt+=V){let jt=b[Rt];if(jt==null)continue;if(je!=null){let J=je[Rt]??0;if(jt-J==0)continue;it=_(J,E,M,B)}let se=S.distr!=2||c!=null?y[Rt]:Rt,wt=A(se,S,v,T),Ie=_(be(jt,Y),E,M,B),Vt=L(wt-st),qt=L(Wn(Ie,it)),N=L(Ii(Ie,it)),R=qt-N;if(jt!=null){let J=jt<0?W:en,mt=jt<0?en:W;It?(Ht>0&&Jt[Rt]!=null&&O(Re.get(Jt[Rt]),Vt,N+oi(Ht/2),ot,Wn(0,R-Ht),J,mt),Zt[Rt]!=null&&O($t.get(Zt[Rt]),Vt,N+oi(Ht/2),ot,Wn(0,R-Ht),J,mt)):O(hn,Vt,N+oi(Ht/2),ot,Wn(0,R-Ht),J,mt),H(p,m,Rt,Vt-Ht/2,N,ot+Ht,R)}}return Ht>0?fe.stroke=It?Re:hn:It||(fe._fill=d.width==0?d._fill:d._stroke??d._fill,fe.width=0),fe.fill=It?$t:hn,fe})}function _y(i,t){let e=be(t?.alignGaps,0);return(n,s,r,o)=>fr(n,s,(a,l,c,f,h,u,p,m,x,g,d)=>{[r,o]=dl(c,r,o);let y=a.pxRound,b=k=>y(u(k,f,g,m)),S=k=>y(p(k,h,d,x)),E,A,_;f.ori==0?(E=xl,_=jr,A=mm):(E=yl,_=Zr,A=gm);let T=f.dir*(f.ori==0?1:-1),B=b(l[T==1?r:o]),v=B,M=[],L=[];for(let k=T==1?r:o;k>=r&&k<=o;k+=T)if(c[k]!=null){let V=l[k],O=b(V);M.push(v=O),L.push(S(c[k]))}let I={stroke:i(M,L,E,_,A,y),fill:null,clip:null,band:null,gaps:null,flags:Yr},D=I.stroke,[F,G]=Eu(n,s);if(a.fill!=null||F!=0){let k=I.fill=new Path2D(D),tt=a.fillTo(n,s,a.min,a.max,F),V=S(tt);_(k,v,V),_(k,B,V)}if(!a.spanGaps){let k=[];k.push(...Tu(l,c,r,o,T,b,e)),I.gaps=k=a.gaps(n,s,r,o,k),I.clip=_l(k,f.ori,m,x,g,d)}return G!=0&&(I.band=G==2?[ds(n,s,r,o,D,-1),ds(n,s,r,o,D,1)]:ds(n,s,r,o,D,G)),I})}function xy(i){return _y(yy,i)}function yy(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),f=Array(o-1),h=Array(o-1);for(let u=0;u<o-1;u++)f[u]=t[u+1]-t[u],h[u]=i[u+1]-i[u],c[u]=f[u]/h[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(h[u-1]+h[u])/((2*h[u]+h[u-1])/c[u-1]+(h[u]+2*h[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+h[u]/3,t[u]+l[u]*h[u]/3,i[u+1]-h[u]/3,t[u+1]-l[u+1]*h[u]/3,i[u+1],t[u+1])}return a}var fu=new Set;function Np(){for(let i of fu)i.syncRect(!0)}$r&&(hr(Q_,Hr,Np),hr(tx,Hr,Np,!0),hr(hl,Hr,()=>{ln.pxRatio=Te}));var vy=ym(),My=_m();function Up(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>du(r,o,t,e))}function Sy(i,t){return i.map((e,n)=>n==0?{}:_n({},t,e))}function du(i,t,e,n){return _n({},t==0?e:n,i)}function vm(i,t,e){return t==null?Xr:[t,e]}var wy=vm;function by(i,t,e){return t==null?Xr:ul(t,e,xu,!0)}function Mm(i,t,e,n){return t==null?Xr:pl(t,e,i.scales[n].log,!1)}var Ey=Mm;function Sm(i,t,e,n){return t==null?Xr:_u(t,e,i.scales[n].log,!1)}var Ty=Sm;function Ay(i,t,e,n,s){let r=Wn(dp(i),dp(t)),o=t-i,a=Pi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Bs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Fp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=vn((e=+s)*Te))+"px"),[i,t,e]}function Ry(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Oe(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(i,t,e){let n={mode:be(i.mode,1)},s=n.mode;function r(w,C,U,z){let j=C.valToPct(w);return z+U*(C.dir==-1?1-j:j)}function o(w,C,U,z){let j=C.valToPct(w);return z+U*(C.dir==-1?j:1-j)}function a(w,C,U,z){return C.ori==0?r(w,C,U,z):o(w,C,U,z)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=xi(U_);if(i.id!=null&&(c.id=i.id),ri(c,i.class),i.title){let w=xi(B_,c);w.textContent=i.title}let f=Ci("canvas"),h=n.ctx=f.getContext("2d"),u=xi(k_,c);hr("click",u,w=>{w.target===m&&(ze!=Dr||Ze!=Nr)&&Ln.click(n,w)},!0);let p=n.under=xi(z_,u);u.appendChild(f);let m=n.over=xi(V_,u);i=qr(i);let x=+be(i.pxAlign,1),g=Lp(x);(i.plugins||[]).forEach(w=>{w.opts&&(i=w.opts(n,i)||i)});let d=i.ms||.001,y=n.series=s==1?Up(i.series||[],Ep,Pp,!1):Sy(i.series||[null],Cp),b=n.axes=Up(i.axes||[],bp,Ap,!0),S=n.scales={},E=n.bands=i.bands||[];E.forEach(w=>{w.fill=ye(w.fill||null),w.dir=be(w.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,_={axes:as,series:pe},T=(i.drawOrder||["axes","series"]).map(w=>_[w]);function B(w){let C=w.distr==3?U=>fs(U>0?U:w.clamp(n,U,w.min,w.max,w.key)):w.distr==4?U=>tu(U,w.asinh):w.distr==100?U=>w.fwd(U):U=>U;return U=>{let z=C(U),{_min:j,_max:nt}=w,dt=nt-j;return(z-j)/dt}}function v(w){let C=S[w];if(C==null){let U=(i.scales||Jo)[w]||Jo;if(U.from!=null){v(U.from);let z=_n({},S[U.from],U,{key:w});z.valToPct=B(z),S[w]=z}else{C=S[w]=_n({},w==A?hm:hy,U),C.key=w;let z=C.time,j=C.range,nt=Os(j);if((w!=A||s==2&&!z)&&(nt&&(j[0]==null||j[1]==null)&&(j={min:j[0]==null?hp:{mode:1,hard:j[0],soft:j[0]},max:j[1]==null?hp:{mode:1,hard:j[1],soft:j[1]}},nt=!1),!nt&&gl(j))){let dt=j;j=(gt,Mt,Ut)=>Mt==null?Xr:ul(Mt,Ut,dt)}C.range=ye(j||(z?wy:w==A?C.distr==3?Ey:C.distr==4?Ty:vm:C.distr==3?Mm:C.distr==4?Sm:by)),C.auto=ye(nt?!1:C.auto),C.clamp=ye(C.clamp||cy),C._min=C._max=null,C.valToPct=B(C)}}}v("x"),v("y"),s==1&&y.forEach(w=>{v(w.scale)}),b.forEach(w=>{v(w.scale)});for(let w in i.scales)v(w);let M=S[A],L=M.distr,I,D;M.ori==0?(ri(c,F_),I=r,D=o):(ri(c,O_),I=o,D=r);let F={};for(let w in S){let C=S[w];(C.min!=null||C.max!=null)&&(F[w]={min:C.min,max:C.max},C.min=C.max=null)}let G=i.tzDate||(w=>new Date(vn(w/d))),k=i.fmtDate||Mu,tt=d==1?Fx(G):kx(G),V=Mp(G,vp(d==1?Ux:Bx,k)),O=wp(G,Sp(Vx,k)),H=[],Z=n.legend=_n({},Wx,i.legend),$=n.cursor=_n({},Zx,{drag:{y:s==2}},i.cursor),Y=Z.show,it=$.show,st=Z.markers;Z.idxs=H,st.width=ye(st.width),st.dash=ye(st.dash),st.stroke=ye(st.stroke),st.fill=ye(st.fill);let ot,ut,Nt,Ht=[],It=[],Zt,$t=!1,Jt={};if(Z.live){let w=y[1]?y[1].values:null;$t=w!=null,Zt=$t?w(n,1,0):{_:0};for(let C in Zt)Jt[C]=mu}if(Y)if(ot=Ci("table",Y_,c),Nt=Ci("tbody",null,ot),Z.mount(n,ot),$t){ut=Ci("thead",null,ot,Nt);let w=Ci("tr",null,ut);Ci("th",null,w);for(var Re in Zt)Ci("th",Jd,w).textContent=Re}else ri(ot,j_),Z.live&&ri(ot,$_);let Me={show:!0},$e={show:!1};function Se(w,C){if(C==0&&($t||!Z.live||s==2))return Xr;let U=[],z=Ci("tr",Z_,Nt,Nt.childNodes[C]);ri(z,w.class),w.show||ri(z,cr);let j=Ci("th",null,z);if(st.show){let gt=xi(J_,j);if(C>0){let Mt=st.width(n,C);Mt&&(gt.style.border=Mt+"px "+st.dash(n,C)+" "+st.stroke(n,C)),gt.style.background=st.fill(n,C)}}let nt=xi(Jd,j);w.label instanceof HTMLElement?nt.appendChild(w.label):nt.textContent=w.label,C>0&&(st.show||(nt.style.color=w.width>0?st.stroke(n,C):st.fill(n,C)),fe("click",j,gt=>{if($._lock)return;te(gt);let Mt=y.indexOf(w);if((gt.ctrlKey||gt.metaKey)!=Z.isolate){let Ut=y.some((Ft,Bt)=>Bt>0&&Bt!=Mt&&Ft.show);y.forEach((Ft,Bt)=>{Bt>0&&Wi(Bt,Ut?Bt==Mt?Me:$e:Me,!0,gn.setSeries)})}else Wi(Mt,{show:!w.show},!0,gn.setSeries)},!1),ee&&fe(ep,j,gt=>{$._lock||(te(gt),Wi(y.indexOf(w),Fr,!0,gn.setSeries))},!1));for(var dt in Zt){let gt=Ci("td",K_,z);gt.textContent="--",U.push(gt)}return[z,U]}let tn=new Map;function fe(w,C,U,z=!0){let j=tn.get(C)||{},nt=$.bind[w](n,C,U,z);nt&&(hr(w,C,j[w]=nt),tn.set(C,j))}function hn(w,C,U){let z=tn.get(C)||{};for(let j in z)(w==null||j==w)&&(au(j,C,z[j]),delete z[j]);w==null&&tn.delete(C)}let je=0,en=0,W=0,Rt=0,jt=0,se=0,wt=jt,Ie=se,Vt=W,qt=Rt,N=0,R=0,J=0,mt=0;n.bbox={};let ft=!1,yt=!1,vt=!1,at=!1,ct=!1,_t=!1;function X(w,C,U){(U||w!=n.width||C!=n.height)&&ht(w,C),ce(!1),vt=!0,yt=!0,Nn()}function ht(w,C){n.width=je=W=w,n.height=en=Rt=C,jt=se=0,bt(),Wt();let U=n.bbox;N=U.left=ar(jt*Te,.5),R=U.top=ar(se*Te,.5),J=U.width=ar(W*Te,.5),mt=U.height=ar(Rt*Te,.5)}let lt=3;function Et(){let w=!1,C=0;for(;!w;){C++;let U=Pr(C),z=Hi(C);w=C==lt||U&&z,w||(ht(n.width,n.height),yt=!0)}}function xt({width:w,height:C}){X(w,C)}n.setSize=xt;function bt(){let w=!1,C=!1,U=!1,z=!1;b.forEach((j,nt)=>{if(j.show&&j._show){let{side:dt,_size:gt}=j,Mt=dt%2,Ut=j.label!=null?j.labelSize:0,Ft=gt+Ut;Ft>0&&(Mt?(W-=Ft,dt==3?(jt+=Ft,z=!0):U=!0):(Rt-=Ft,dt==0?(se+=Ft,w=!0):C=!0))}}),Vi[0]=w,Vi[1]=U,Vi[2]=C,Vi[3]=z,W-=Ti[1]+Ti[3],jt+=Ti[3],Rt-=Ti[2]+Ti[0],se+=Ti[0]}function Wt(){let w=jt+W,C=se+Rt,U=jt,z=se;function j(nt,dt){switch(nt){case 1:return w+=dt,w-dt;case 2:return C+=dt,C-dt;case 3:return U-=dt,U+dt;case 0:return z-=dt,z+dt}}b.forEach((nt,dt)=>{if(nt.show&&nt._show){let gt=nt.side;nt._pos=j(gt,nt._size),nt.label!=null&&(nt._lpos=j(gt,nt.labelSize))}})}if($.dataIdx==null){let w=$.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let U=w.prox=ye(w.prox),z=w.bias??=0;$.dataIdx=(j,nt,dt,gt)=>{if(nt==0)return dt;let Mt=dt,Ut=U(j,nt,dt,gt)??Fe,Ft=Ut>=0&&Ut<Fe,Bt=M.ori==0?W:Rt,oe=$.left,Ee=t[0],we=t[nt];if(C.has(we[dt])){Mt=null;let _e=null,Qt=null,Xt;if(z==0||z==-1)for(Xt=dt;_e==null&&Xt-- >0;)C.has(we[Xt])||(_e=Xt);if(z==0||z==1)for(Xt=dt;Qt==null&&Xt++<we.length;)C.has(we[Xt])||(Qt=Xt);if(_e!=null||Qt!=null)if(Ft){let Ge=_e==null?-1/0:I(Ee[_e],M,Bt,0),rn=Qt==null?1/0:I(Ee[Qt],M,Bt,0),Rn=oe-Ge,Ue=rn-oe;Rn<=Ue?Rn<=Ut&&(Mt=_e):Ue<=Ut&&(Mt=Qt)}else Mt=Qt==null?_e:_e==null?Qt:dt-_e<=Qt-dt?_e:Qt}else Ft&&Mn(oe-I(Ee[dt],M,Bt,0))>Ut&&(Mt=null);return Mt}}let te=w=>{$.event=w};$.idxs=H,$._lock=!1;let pt=$.points;pt.show=ye(pt.show),pt.size=ye(pt.size),pt.stroke=ye(pt.stroke),pt.width=ye(pt.width),pt.fill=ye(pt.fill);let kt=n.focus=_n({},i.focus||{alpha:.3},$.focus),ee=kt.prox>=0,Ct=ee&&pt.one,ae=[],ke=[],kn=[];function Oo(w,C){let U=pt.show(n,C);if(U instanceof HTMLElement)return ri(U,q_),ri(U,w.class),ji(U,-10,-10,W,Rt),m.insertBefore(U,ae[C]),U}function Ar(w,C){if(s==1||C>0){let U=s==1&&S[w.scale].time,z=w.value;w.value=U?gp(z)?wp(G,Sp(z,k)):z||O:z||oy,w.label=w.label||(U?Kx:Jx)}if(Ct||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||vy||hx,w.fillTo=ye(w.fillTo||uy),w.pxAlign=+be(w.pxAlign,x),w.pxRound=Lp(w.pxAlign),w.stroke=ye(w.stroke||null),w.fill=ye(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let U=ay(Wn(1,w.width),1),z=w.points=_n({},{size:U,width:Wn(1,U*.2),stroke:w.stroke,space:U*2,paths:My,_stroke:null,_fill:null},w.points);z.show=ye(z.show),z.filter=ye(z.filter),z.fill=ye(z.fill),z.stroke=ye(z.stroke),z.paths=ye(z.paths),z.pxAlign=w.pxAlign}if(Y){let U=Se(w,C);Ht.splice(C,0,U[0]),It.splice(C,0,U[1]),Z.values.push(null)}if(it){H.splice(C,0,null);let U=null;Ct?C==0&&(U=Oo(w,C)):C>0&&(U=Oo(w,C)),ae.splice(C,0,U),ke.splice(C,0,0),kn.splice(C,0,0)}An("addSeries",C)}function Fh(w,C){C=C??y.length,w=s==1?du(w,C,Ep,Pp):du(w,C,{},Cp),y.splice(C,0,w),Ar(y[C],C)}n.addSeries=Fh;function Za(w){if(y.splice(w,1),Y){Z.values.splice(w,1),It.splice(w,1);let C=Ht.splice(w,1)[0];hn(null,C.firstChild),C.remove()}it&&(H.splice(w,1),ae.splice(w,1)[0].remove(),ke.splice(w,1),kn.splice(w,1)),An("delSeries",w)}n.delSeries=Za;let Vi=[!1,!1,!1,!1];function ss(w,C){if(w._show=w.show,w.show){let U=w.side%2,z=S[w.scale];z==null&&(w.scale=U?y[1].scale:A,z=S[w.scale]);let j=z.time;w.size=ye(w.size),w.space=ye(w.space),w.rotate=ye(w.rotate),Os(w.incrs)&&w.incrs.forEach(dt=>{!Bs.has(dt)&&Bs.set(dt,Xp(dt))}),w.incrs=ye(w.incrs||(z.distr==2?Lx:j?d==1?Nx:Ox:lr)),w.splits=ye(w.splits||(j&&z.distr==1?tt:z.distr==3?cu:z.distr==4?ey:ty)),w.stroke=ye(w.stroke),w.grid.stroke=ye(w.grid.stroke),w.ticks.stroke=ye(w.ticks.stroke),w.border.stroke=ye(w.border.stroke);let nt=w.values;w.values=Os(nt)&&!Os(nt[0])?ye(nt):j?Os(nt)?Mp(G,vp(nt,k)):gp(nt)?zx(G,nt):nt||V:nt||Qx,w.filter=ye(w.filter||(z.distr>=3&&z.log==10?sy:z.distr==3&&z.log==2?ry:Hp)),w.font=Fp(w.font),w.labelFont=Fp(w.labelFont),w._size=w.size(n,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Vi[C]=!0,w._el=xi(G_,u))}}function rs(w,C,U,z){let[j,nt,dt,gt]=U,Mt=C%2,Ut=0;return Mt==0&&(gt||nt)&&(Ut=C==0&&!j||C==2&&!dt?vn(bp.size/3):0),Mt==1&&(j||dt)&&(Ut=C==1&&!nt||C==3&&!gt?vn(Ap.size/2):0),Ut}let Bo=n.padding=(i.padding||[rs,rs,rs,rs]).map(w=>ye(be(w,rs))),Ti=n._padding=Bo.map((w,C)=>w(n,C,Vi,0)),nn,un=null,fn=null,Gi=s==1?y[0].idxs:null,ei=null,Rs=!1;function ko(w,C){if(t=w??[],n.data=n._data=t,s==2){nn=0;for(let U=1;U<y.length;U++)nn+=t[U][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ei=t[0],nn=ei.length;let U=t;if(L==2){U=t.slice();let z=U[0]=Array(nn);for(let j=0;j<nn;j++)z[j]=j}n._data=t=U}if(ce(!0),An("setData"),L==2&&(vt=!0),C!==!1){let U=M;U.auto(n,Rs)?zo():Is(A,U.min,U.max),at=at||$.left>=0,_t=!0,Nn()}}n.setData=ko;function zo(){Rs=!0;let w,C;s==1&&(nn>0?(un=Gi[0]=0,fn=Gi[1]=nn-1,w=t[0][un],C=t[0][fn],L==2?(w=un,C=fn):w==C&&(L==3?[w,C]=pl(w,w,M.log,!1):L==4?[w,C]=_u(w,w,M.log,!1):M.time?C=w+vn(86400/d):[w,C]=ul(w,C,xu,!0))):(un=Gi[0]=w=null,fn=Gi[1]=C=null)),Is(A,w,C)}let Rr,Cs,Cr,P,q,rt,Q,et,Tt,Pt;function At(w,C,U,z,j,nt){w??=Qd,U??=vu,z??="butt",j??=Qd,nt??="round",w!=Rr&&(h.strokeStyle=Rr=w),j!=Cs&&(h.fillStyle=Cs=j),C!=Cr&&(h.lineWidth=Cr=C),nt!=q&&(h.lineJoin=q=nt),z!=rt&&(h.lineCap=rt=z),U!=P&&h.setLineDash(P=U)}function Lt(w,C,U,z){C!=Cs&&(h.fillStyle=Cs=C),w!=Q&&(h.font=Q=w),U!=et&&(h.textAlign=et=U),z!=Tt&&(h.textBaseline=Tt=z)}function Gt(w,C,U,z,j=0){if(z.length>0&&w.auto(n,Rs)&&(C==null||C.min==null)){let nt=be(un,0),dt=be(fn,z.length-1),gt=U.min==null?sx(z,nt,dt,j,w.distr==3):[U.min,U.max];w.min=Ii(w.min,U.min=gt[0]),w.max=Wn(w.max,U.max=gt[1])}}let ie={min:null,max:null};function de(){for(let z in S){let j=S[z];F[z]==null&&(j.min==null||F[A]!=null&&j.auto(n,Rs))&&(F[z]=ie)}for(let z in S){let j=S[z];F[z]==null&&j.from!=null&&F[j.from]!=null&&(F[z]=ie)}F[A]!=null&&ce(!0);let w={};for(let z in F){let j=F[z];if(j!=null){let nt=w[z]=qr(S[z],dx);if(j.min!=null)_n(nt,j);else if(z!=A||s==2)if(nn==0&&nt.from==null){let dt=nt.range(n,null,null,z);nt.min=dt[0],nt.max=dt[1]}else nt.min=Fe,nt.max=-Fe}}if(nn>0){y.forEach((z,j)=>{if(s==1){let nt=z.scale,dt=F[nt];if(dt==null)return;let gt=w[nt];if(j==0){let Mt=gt.range(n,gt.min,gt.max,nt);gt.min=Mt[0],gt.max=Mt[1],un=Pi(gt.min,t[0]),fn=Pi(gt.max,t[0]),fn-un>1&&(t[0][un]<gt.min&&un++,t[0][fn]>gt.max&&fn--),z.min=ei[un],z.max=ei[fn]}else z.show&&z.auto&&Gt(gt,dt,z,t[j],z.sorted);z.idxs[0]=un,z.idxs[1]=fn}else if(j>0&&z.show&&z.auto){let[nt,dt]=z.facets,gt=nt.scale,Mt=dt.scale,[Ut,Ft]=t[j],Bt=w[gt],oe=w[Mt];Bt!=null&&Gt(Bt,F[gt],nt,Ut,nt.sorted),oe!=null&&Gt(oe,F[Mt],dt,Ft,dt.sorted),z.min=dt.min,z.max=dt.max}});for(let z in w){let j=w[z],nt=F[z];if(j.from==null&&(nt==null||nt.min==null)){let dt=j.range(n,j.min==Fe?null:j.min,j.max==-Fe?null:j.max,z);j.min=dt[0],j.max=dt[1]}}}for(let z in w){let j=w[z];if(j.from!=null){let nt=w[j.from];if(nt.min==null)j.min=j.max=null;else{let dt=j.range(n,nt.min,nt.max,z);j.min=dt[0],j.max=dt[1]}}}let C={},U=!1;for(let z in w){let j=w[z],nt=S[z];if(nt.min!=j.min||nt.max!=j.max){nt.min=j.min,nt.max=j.max;let dt=nt.distr;nt._min=dt==3?fs(nt.min):dt==4?tu(nt.min,nt.asinh):dt==100?nt.fwd(nt.min):nt.min,nt._max=dt==3?fs(nt.max):dt==4?tu(nt.max,nt.asinh):dt==100?nt.fwd(nt.max):nt.max,C[z]=U=!0}}if(U){y.forEach((z,j)=>{s==2?j>0&&C.y&&(z._paths=null):C[z.scale]&&(z._paths=null)});for(let z in C)vt=!0,An("setScale",z);it&&$.left>=0&&(at=_t=!0)}for(let z in F)F[z]=null}function zt(w){let C=lu(un-1,0,nn-1),U=lu(fn+1,0,nn-1);for(;w[C]==null&&C>0;)C--;for(;w[U]==null&&U<nn-1;)U++;return[C,U]}function pe(){if(nn>0){let w=y.some(C=>C._focus)&&Pt!=kt.alpha;w&&(h.globalAlpha=Pt=kt.alpha),y.forEach((C,U)=>{if(U>0&&C.show&&(Qe(U,!1),Qe(U,!0),C._paths==null)){let z=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha);let j=s==2?[0,t[U][0].length-1]:zt(t[U]);C._paths=C.paths(n,U,j[0],j[1]),Pt!=z&&(h.globalAlpha=Pt=z)}}),y.forEach((C,U)=>{if(U>0&&C.show){let z=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha),C._paths!=null&&Le(U,!1);{let j=C._paths!=null?C._paths.gaps:null,nt=C.points.show(n,U,un,fn,j),dt=C.points.filter(n,U,nt,j);(nt||dt)&&(C.points._paths=C.points.paths(n,U,un,fn,dt),Le(U,!0))}Pt!=z&&(h.globalAlpha=Pt=z),An("drawSeries",U)}}),w&&(h.globalAlpha=Pt=1)}}function Qe(w,C){let U=C?y[w].points:y[w];U._stroke=U.stroke(n,w),U._fill=U.fill(n,w)}function Le(w,C){let U=C?y[w].points:y[w],{stroke:z,fill:j,clip:nt,flags:dt,_stroke:gt=U._stroke,_fill:Mt=U._fill,_width:Ut=U.width}=U._paths;Ut=Oe(Ut*Te,3);let Ft=null,Bt=Ut%2/2;C&&Mt==null&&(Mt=Ut>0?"#fff":gt);let oe=U.pxAlign==1&&Bt>0;if(oe&&h.translate(Bt,Bt),!C){let Ee=N-Ut/2,we=R-Ut/2,_e=J+Ut,Qt=mt+Ut;Ft=new Path2D,Ft.rect(Ee,we,_e,Qt)}C?Ot(gt,Ut,U.dash,U.cap,Mt,z,j,dt,nt):De(w,gt,Ut,U.dash,U.cap,Mt,z,j,dt,Ft,nt),oe&&h.translate(-Bt,-Bt)}function De(w,C,U,z,j,nt,dt,gt,Mt,Ut,Ft){let Bt=!1;Mt!=0&&E.forEach((oe,Ee)=>{if(oe.series[0]==w){let we=y[oe.series[1]],_e=t[oe.series[1]],Qt=(we._paths||Jo).band;Os(Qt)&&(Qt=oe.dir==1?Qt[0]:Qt[1]);let Xt,Ge=null;we.show&&Qt&&ox(_e,un,fn)?(Ge=oe.fill(n,Ee)||nt,Xt=we._paths.clip):Qt=null,Ot(C,U,z,j,Ge,dt,gt,Mt,Ut,Ft,Xt,Qt),Bt=!0}}),Bt||Ot(C,U,z,j,nt,dt,gt,Mt,Ut,Ft)}let yn=Yr|uu;function Ot(w,C,U,z,j,nt,dt,gt,Mt,Ut,Ft,Bt){At(w,C,U,z,j),(Mt||Ut||Bt)&&(h.save(),Mt&&h.clip(Mt),Ut&&h.clip(Ut)),Bt?(gt&yn)==yn?(h.clip(Bt),Ft&&h.clip(Ft),xe(j,dt),dn(w,nt,C)):gt&uu?(xe(j,dt),h.clip(Bt),dn(w,nt,C)):gt&Yr&&(h.save(),h.clip(Bt),Ft&&h.clip(Ft),xe(j,dt),h.restore(),dn(w,nt,C)):(xe(j,dt),dn(w,nt,C)),(Mt||Ut||Bt)&&h.restore()}function dn(w,C,U){U>0&&(C instanceof Map?C.forEach((z,j)=>{h.strokeStyle=Rr=j,h.stroke(z)}):C!=null&&w&&h.stroke(C))}function xe(w,C){C instanceof Map?C.forEach((U,z)=>{h.fillStyle=Cs=z,h.fill(U)}):C!=null&&w&&h.fill(C)}function os(w,C,U,z){let j=b[w],nt;if(z<=0)nt=[0,0];else{let dt=j._space=j.space(n,w,C,U,z),gt=j._incrs=j.incrs(n,w,C,U,z,dt);nt=Ay(C,U,gt,z,dt)}return j._found=nt}function pn(w,C,U,z,j,nt,dt,gt,Mt,Ut){let Ft=dt%2/2;x==1&&h.translate(Ft,Ft),At(gt,dt,Mt,Ut,gt),h.beginPath();let Bt,oe,Ee,we,_e=j+(z==0||z==3?-nt:nt);U==0?(oe=j,we=_e):(Bt=j,Ee=_e);for(let Qt=0;Qt<w.length;Qt++)C[Qt]!=null&&(U==0?Bt=Ee=w[Qt]:oe=we=w[Qt],h.moveTo(Bt,oe),h.lineTo(Ee,we));h.stroke(),x==1&&h.translate(-Ft,-Ft)}function Pr(w){let C=!0;return b.forEach((U,z)=>{if(!U.show)return;let j=S[U.scale];if(j.min==null){U._show&&(C=!1,U._show=!1,ce(!1));return}else U._show||(C=!1,U._show=!0,ce(!1));let nt=U.side,dt=nt%2,{min:gt,max:Mt}=j,[Ut,Ft]=os(z,gt,Mt,dt==0?W:Rt);if(Ft==0)return;let Bt=j.distr==2,oe=U._splits=U.splits(n,z,gt,Mt,Ut,Ft,Bt),Ee=j.distr==2?oe.map(Xt=>ei[Xt]):oe,we=j.distr==2?ei[oe[1]]-ei[oe[0]]:Ut,_e=U._values=U.values(n,U.filter(n,Ee,z,Ft,we),z,Ft,we);U._rotate=nt==2?U.rotate(n,_e,z,Ft):0;let Qt=U._size;U._size=yi(U.size(n,_e,z,w)),Qt!=null&&U._size!=Qt&&(C=!1)}),C}function Hi(w){let C=!0;return Bo.forEach((U,z)=>{let j=U(n,z,Vi,w);j!=Ti[z]&&(C=!1),Ti[z]=j}),C}function as(){for(let w=0;w<b.length;w++){let C=b[w];if(!C.show||!C._show)continue;let U=C.side,z=U%2,j,nt,dt=C.stroke(n,w),gt=U==0||U==3?-1:1,[Mt,Ut]=C._found;if(C.label!=null){let Gn=C.labelGap*gt,si=vn((C._lpos+Gn)*Te);Lt(C.labelFont[0],dt,"center",U==2?"top":Kd),h.save(),z==1?(j=nt=0,h.translate(si,vn(R+mt/2)),h.rotate((U==3?-cl:cl)/2)):(j=vn(N+J/2),nt=si);let sr=Vp(C.label)?C.label(n,w,Mt,Ut):C.label;h.fillText(sr,j,nt),h.restore()}if(Ut==0)continue;let Ft=S[C.scale],Bt=z==0?J:mt,oe=z==0?N:R,Ee=C._splits,we=Ft.distr==2?Ee.map(Gn=>ei[Gn]):Ee,_e=Ft.distr==2?ei[Ee[1]]-ei[Ee[0]]:Mt,Qt=C.ticks,Xt=C.border,Ge=Qt.show?Qt.size:0,rn=vn(Ge*Te),Rn=vn((C.alignTo==2?C._size-Ge-C.gap:C.gap)*Te),Ue=C._rotate*-cl/180,on=g(C._pos*Te),ni=(rn+Rn)*gt,Vn=on+ni;nt=z==0?Vn:0,j=z==1?Vn:0;let gi=C.font[0],Ai=C.align==1?Vr:C.align==2?Jh:Ue>0?Vr:Ue<0?Jh:z==0?"center":U==3?Jh:Vr,qi=Ue||z==1?"middle":U==2?"top":Kd;Lt(gi,dt,Ai,qi);let ii=C.font[1]*C.lineGap,_i=Ee.map(Gn=>g(a(Gn,Ft,Bt,oe))),Ri=C._values;for(let Gn=0;Gn<Ri.length;Gn++){let si=Ri[Gn];if(si!=null){z==0?j=_i[Gn]:nt=_i[Gn],si=""+si;let sr=si.indexOf(`
`)==-1?[si]:si.split(/\n/gm);for(let Hn=0;Hn<sr.length;Hn++){let Dd=sr[Hn];Ue?(h.save(),h.translate(j,nt+Hn*ii),h.rotate(Ue),h.fillText(Dd,0,0),h.restore()):h.fillText(Dd,j,nt+Hn*ii)}}}Qt.show&&pn(_i,Qt.filter(n,we,w,Ut,_e),z,U,on,rn,Oe(Qt.width*Te,3),Qt.stroke(n,w),Qt.dash,Qt.cap);let Yi=C.grid;Yi.show&&pn(_i,Yi.filter(n,we,w,Ut,_e),z,z==0?2:1,z==0?R:N,z==0?mt:J,Oe(Yi.width*Te,3),Yi.stroke(n,w),Yi.dash,Yi.cap),Xt.show&&pn([on],[1],z==0?1:0,z==0?1:2,z==1?R:N,z==1?mt:J,Oe(Xt.width*Te,3),Xt.stroke(n,w),Xt.dash,Xt.cap)}An("drawAxes")}function ce(w){y.forEach((C,U)=>{U>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(z=>{z.min=null,z.max=null})))})}let sn=!1,zn=!1,Ne=[];function mn(){zn=!1;for(let w=0;w<Ne.length;w++)An(...Ne[w]);Ne.length=0}function Nn(){sn||(vx(md),sn=!0)}function Ja(w,C=!1){sn=!0,zn=C,w(n),md(),C&&Ne.length>0&&queueMicrotask(mn)}n.batch=Ja;function md(){if(ft&&(de(),ft=!1),vt&&(Et(),vt=!1),yt){if(We(p,Vr,jt),We(p,"top",se),We(p,Yo,W),We(p,$o,Rt),We(m,Vr,jt),We(m,"top",se),We(m,Yo,W),We(m,$o,Rt),We(u,Yo,je),We(u,$o,en),f.width=vn(je*Te),f.height=vn(en*Te),b.forEach(({_el:w,_show:C,_size:U,_pos:z,side:j})=>{if(w!=null)if(C){let nt=j===3||j===0?U:0,dt=j%2==1;We(w,dt?"left":"top",z-nt),We(w,dt?"width":"height",U),We(w,dt?"top":"left",dt?se:jt),We(w,dt?"height":"width",dt?Rt:W),ou(w,cr)}else ri(w,cr)}),Rr=Cs=Cr=q=rt=Q=et=Tt=P=null,Pt=1,Ho(!0),jt!=wt||se!=Ie||W!=Vt||Rt!=qt){ce(!1);let w=W/Vt,C=Rt/qt;if(it&&!at&&$.left>=0){$.left*=w,$.top*=C,Ir&&ji(Ir,vn($.left),0,W,Rt),Lr&&ji(Lr,0,vn($.top),W,Rt);for(let U=0;U<ae.length;U++){let z=ae[U];z!=null&&(ke[U]*=w,kn[U]*=C,ji(z,yi(ke[U]),yi(kn[U]),W,Rt))}}if(Ve.show&&!ct&&Ve.left>=0&&Ve.width>0){Ve.left*=w,Ve.width*=w,Ve.top*=C,Ve.height*=C;for(let U in Gh)We(Ur,U,Ve[U])}wt=jt,Ie=se,Vt=W,qt=Rt}An("setSize"),yt=!1}je>0&&en>0&&(h.clearRect(0,0,f.width,f.height),An("drawClear"),T.forEach(w=>w()),An("draw")),Ve.show&&ct&&(Ka(Ve),ct=!1),it&&at&&(ir(null,!0,!1),at=!1),Z.show&&Z.live&&_t&&(zh(),_t=!1),l||(l=!0,n.status=1,An("ready")),Rs=!1,sn=!1}n.redraw=(w,C)=>{vt=C||!1,w!==!1?Is(A,M.min,M.max):Nn()};function Oh(w,C){let U=S[w];if(U.from==null){if(nn==0){let z=U.range(n,C.min,C.max,w);C.min=z[0],C.max=z[1]}if(C.min>C.max){let z=C.min;C.min=C.max,C.max=z}if(nn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==A&&U.distr==2&&nn>0&&(C.min=Pi(C.min,t[0]),C.max=Pi(C.max,t[0]),C.min==C.max&&C.max++),F[w]=C,ft=!0,Nn()}}n.setScale=Oh;let Bh,kh,Ir,Lr,gd,_d,Dr,Nr,xd,yd,ze,Ze,Ps=!1,Ln=$.drag,En=Ln.x,Tn=Ln.y;it&&($.x&&(Bh=xi(W_,m)),$.y&&(kh=xi(X_,m)),M.ori==0?(Ir=Bh,Lr=kh):(Ir=kh,Lr=Bh),ze=$.left,Ze=$.top);let Ve=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ur=Ve.show?xi(H_,Ve.over?m:p):null;function Ka(w,C){if(Ve.show){for(let U in w)Ve[U]=w[U],U in Gh&&We(Ur,U,w[U]);C!==!1&&An("setSelect")}}n.setSelect=Ka;function e_(w){if(y[w].show)Y&&ou(Ht[w],cr);else if(Y&&ri(Ht[w],cr),it){let U=Ct?ae[0]:ae[w];U!=null&&ji(U,-10,-10,W,Rt)}}function Is(w,C,U){Oh(w,{min:C,max:U})}function Wi(w,C,U,z){C.focus!=null&&o_(w),C.show!=null&&y.forEach((j,nt)=>{nt>0&&(w==nt||w==null)&&(j.show=C.show,e_(nt),s==2?(Is(j.facets[0].scale,null,null),Is(j.facets[1].scale,null,null)):Is(j.scale,null,null),Nn())}),U!==!1&&An("setSeries",w,C),z&&Wo("setSeries",n,w,C)}n.setSeries=Wi;function n_(w,C){_n(E[w],C)}function i_(w,C){w.fill=ye(w.fill||null),w.dir=be(w.dir,-1),C=C??E.length,E.splice(C,0,w)}function s_(w){w==null?E.length=0:E.splice(w,1)}n.addBand=i_,n.setBand=n_,n.delBand=s_;function r_(w,C){y[w].alpha=C,it&&ae[w]!=null&&(ae[w].style.opacity=C),Y&&Ht[w]&&(Ht[w].style.opacity=C)}let ls,Ls,nr,Fr={focus:!0};function o_(w){if(w!=nr){let C=w==null,U=kt.alpha!=1;y.forEach((z,j)=>{if(s==1||j>0){let nt=C||j==0||j==w;z._focus=C?null:nt,U&&r_(j,nt?1:kt.alpha)}}),nr=w,U&&Nn()}}Y&&ee&&fe(np,ot,w=>{$._lock||(te(w),nr!=null&&Wi(null,Fr,!0,gn.setSeries))});function Xi(w,C,U){let z=S[C];U&&(w=w/Te-(z.ori==1?se:jt));let j=W;z.ori==1&&(j=Rt,w=j-w),z.dir==-1&&(w=j-w);let nt=z._min,dt=z._max,gt=w/j,Mt=nt+(dt-nt)*gt,Ut=z.distr;return Ut==3?Wr(10,Mt):Ut==4?lx(Mt,z.asinh):Ut==100?z.bwd(Mt):Mt}function a_(w,C){let U=Xi(w,A,C);return Pi(U,t[0],un,fn)}n.valToIdx=w=>Pi(w,t[0]),n.posToIdx=a_,n.posToVal=Xi,n.valToPos=(w,C,U)=>S[C].ori==0?r(w,S[C],U?J:W,U?N:0):o(w,S[C],U?mt:Rt,U?R:0),n.setCursor=(w,C,U)=>{ze=w.left,Ze=w.top,ir(null,C,U)};function vd(w,C){We(Ur,Vr,Ve.left=w),We(Ur,Yo,Ve.width=C)}function Md(w,C){We(Ur,"top",Ve.top=w),We(Ur,$o,Ve.height=C)}let Vo=M.ori==0?vd:Md,Go=M.ori==1?vd:Md;function l_(){if(Y&&Z.live)for(let w=s==2?1:0;w<y.length;w++){if(w==0&&$t)continue;let C=Z.values[w],U=0;for(let z in C)It[w][U++].firstChild.nodeValue=C[z]}}function zh(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((U,z)=>{H[z]=U}):fx(w.idx)||H.fill(w.idx),Z.idx=H[0]),Y&&Z.live){for(let U=0;U<y.length;U++)(U>0||s==1&&!$t)&&c_(U,H[U]);l_()}_t=!1,C!==!1&&An("setLegend")}n.setLegend=zh;function c_(w,C){let U=y[w],z=w==0&&L==2?ei:t[w],j;$t?j=U.values(n,w,C)??Jt:(j=U.value(n,C==null?null:z[C],w,C),j=j==null?Jt:{_:j}),Z.values[w]=j}function ir(w,C,U){xd=ze,yd=Ze,[ze,Ze]=$.move(n,ze,Ze),$.left=ze,$.top=Ze,it&&(Ir&&ji(Ir,vn(ze),0,W,Rt),Lr&&ji(Lr,0,vn(Ze),W,Rt));let z,j=un>fn;ls=Fe,Ls=null;let nt=M.ori==0?W:Rt,dt=M.ori==1?W:Rt;if(ze<0||nn==0||j){z=$.idx=null;for(let gt=0;gt<y.length;gt++){let Mt=ae[gt];Mt!=null&&ji(Mt,-10,-10,W,Rt)}ee&&Wi(null,Fr,!0,w==null&&gn.setSeries),Z.live&&(H.fill(z),_t=!0)}else{let gt,Mt,Ut;s==1&&(gt=M.ori==0?ze:Ze,Mt=Xi(gt,A),z=$.idx=Pi(Mt,t[0],un,fn),Ut=I(t[0][z],M,nt,0));let Ft=-10,Bt=-10,oe=0,Ee=0,we=!0,_e="",Qt="";for(let Xt=s==2?1:0;Xt<y.length;Xt++){let Ge=y[Xt],rn=H[Xt],Rn=rn==null?null:s==1?t[Xt][rn]:t[Xt][1][rn],Ue=$.dataIdx(n,Xt,z,Mt),on=Ue==null?null:s==1?t[Xt][Ue]:t[Xt][1][Ue];if(_t=_t||on!=Rn||Ue!=rn,H[Xt]=Ue,Xt>0&&Ge.show){let ni=Ue==null?-10:Ue==z?Ut:I(s==1?t[0][Ue]:t[Xt][0][Ue],M,nt,0),Vn=on==null?-10:D(on,s==1?S[Ge.scale]:S[Ge.facets[1].scale],dt,0);if(ee&&on!=null){let gi=M.ori==1?ze:Ze,Ai=Mn(kt.dist(n,Xt,Ue,Vn,gi));if(Ai<ls){let qi=kt.bias;if(qi!=0){let ii=Xi(gi,Ge.scale),_i=on>=0?1:-1,Ri=ii>=0?1:-1;Ri==_i&&(Ri==1?qi==1?on>=ii:on<=ii:qi==1?on<=ii:on>=ii)&&(ls=Ai,Ls=Xt)}else ls=Ai,Ls=Xt}}if(_t||Ct){let gi,Ai;M.ori==0?(gi=ni,Ai=Vn):(gi=Vn,Ai=ni);let qi,ii,_i,Ri,Yi,Gn,si=!0,sr=pt.bbox;if(sr!=null){si=!1;let Hn=sr(n,Xt);_i=Hn.left,Ri=Hn.top,qi=Hn.width,ii=Hn.height}else _i=gi,Ri=Ai,qi=ii=pt.size(n,Xt);if(Gn=pt.fill(n,Xt),Yi=pt.stroke(n,Xt),Ct)Xt==Ls&&ls<=kt.prox&&(Ft=_i,Bt=Ri,oe=qi,Ee=ii,we=si,_e=Gn,Qt=Yi);else{let Hn=ae[Xt];Hn!=null&&(ke[Xt]=_i,kn[Xt]=Ri,cp(Hn,qi,ii,si),ap(Hn,Gn,Yi),ji(Hn,yi(_i),yi(Ri),W,Rt))}}}}if(Ct){let Xt=kt.prox,Ge=nr==null?ls<=Xt:ls>Xt||Ls!=nr;if(_t||Ge){let rn=ae[0];rn!=null&&(ke[0]=Ft,kn[0]=Bt,cp(rn,oe,Ee,we),ap(rn,_e,Qt),ji(rn,yi(Ft),yi(Bt),W,Rt))}}}if(Ve.show&&Ps)if(w!=null){let[gt,Mt]=gn.scales,[Ut,Ft]=gn.match,[Bt,oe]=w.cursor.sync.scales,Ee=w.cursor.drag;if(En=Ee._x,Tn=Ee._y,En||Tn){let{left:we,top:_e,width:Qt,height:Xt}=w.select,Ge=w.scales[Bt].ori,rn=w.posToVal,Rn,Ue,on,ni,Vn,gi=gt!=null&&Ut(gt,Bt),Ai=Mt!=null&&Ft(Mt,oe);gi&&En?(Ge==0?(Rn=we,Ue=Qt):(Rn=_e,Ue=Xt),on=S[gt],ni=I(rn(Rn,Bt),on,nt,0),Vn=I(rn(Rn+Ue,Bt),on,nt,0),Vo(Ii(ni,Vn),Mn(Vn-ni))):Vo(0,nt),Ai&&Tn?(Ge==1?(Rn=we,Ue=Qt):(Rn=_e,Ue=Xt),on=S[Mt],ni=D(rn(Rn,oe),on,dt,0),Vn=D(rn(Rn+Ue,oe),on,dt,0),Go(Ii(ni,Vn),Mn(Vn-ni))):Go(0,dt)}else Hh()}else{let gt=Mn(xd-gd),Mt=Mn(yd-_d);if(M.ori==1){let oe=gt;gt=Mt,Mt=oe}En=Ln.x&&gt>=Ln.dist,Tn=Ln.y&&Mt>=Ln.dist;let Ut=Ln.uni;Ut!=null?En&&Tn&&(En=gt>=Ut,Tn=Mt>=Ut,!En&&!Tn&&(Mt>gt?Tn=!0:En=!0)):Ln.x&&Ln.y&&(En||Tn)&&(En=Tn=!0);let Ft,Bt;En&&(M.ori==0?(Ft=Dr,Bt=ze):(Ft=Nr,Bt=Ze),Vo(Ii(Ft,Bt),Mn(Bt-Ft)),Tn||Go(0,dt)),Tn&&(M.ori==1?(Ft=Dr,Bt=ze):(Ft=Nr,Bt=Ze),Go(Ii(Ft,Bt),Mn(Bt-Ft)),En||Vo(0,nt)),!En&&!Tn&&(Vo(0,0),Go(0,0))}if(Ln._x=En,Ln._y=Tn,w==null){if(U){if(Ld!=null){let[gt,Mt]=gn.scales;gn.values[0]=gt!=null?Xi(M.ori==0?ze:Ze,gt):null,gn.values[1]=Mt!=null?Xi(M.ori==1?ze:Ze,Mt):null}Wo(Kh,n,ze,Ze,W,Rt,z)}if(ee){let gt=U&&gn.setSeries,Mt=kt.prox;nr==null?ls<=Mt&&Wi(Ls,Fr,!0,gt):ls>Mt?Wi(null,Fr,!0,gt):Ls!=nr&&Wi(Ls,Fr,!0,gt)}}_t&&(Z.idx=z,zh()),C!==!1&&An("setCursor")}let Ds=null;Object.defineProperty(n,"rect",{get(){return Ds==null&&Ho(!1),Ds}});function Ho(w=!1){w?Ds=null:(Ds=m.getBoundingClientRect(),An("syncRect",Ds))}function Sd(w,C,U,z,j,nt,dt){$._lock||Ps&&w!=null&&w.movementX==0&&w.movementY==0||(Vh(w,C,U,z,j,nt,dt,!1,w!=null),w!=null?ir(null,!0,!0):ir(C,!0,!1))}function Vh(w,C,U,z,j,nt,dt,gt,Mt){if(Ds==null&&Ho(!1),te(w),w!=null)U=w.clientX-Ds.left,z=w.clientY-Ds.top;else{if(U<0||z<0){ze=-10,Ze=-10;return}let[Ut,Ft]=gn.scales,Bt=C.cursor.sync,[oe,Ee]=Bt.values,[we,_e]=Bt.scales,[Qt,Xt]=gn.match,Ge=C.axes[0].side%2==1,rn=M.ori==0?W:Rt,Rn=M.ori==1?W:Rt,Ue=Ge?nt:j,on=Ge?j:nt,ni=Ge?z:U,Vn=Ge?U:z;if(we!=null?U=Qt(Ut,we)?a(oe,S[Ut],rn,0):-10:U=rn*(ni/Ue),_e!=null?z=Xt(Ft,_e)?a(Ee,S[Ft],Rn,0):-10:z=Rn*(Vn/on),M.ori==1){let gi=U;U=z,z=gi}}Mt&&(C==null||C.cursor.event.type==Kh)&&((U<=1||U>=W-1)&&(U=ar(U,W)),(z<=1||z>=Rt-1)&&(z=ar(z,Rt))),gt?(gd=U,_d=z,[Dr,Nr]=$.move(n,U,z)):(ze=U,Ze=z)}let Gh={width:0,height:0,left:0,top:0};function Hh(){Ka(Gh,!1)}let wd,bd,Ed,Td;function Ad(w,C,U,z,j,nt,dt){Ps=!0,En=Tn=Ln._x=Ln._y=!1,Vh(w,C,U,z,j,nt,dt,!0,!1),w!=null&&(fe(Qh,su,Rd,!1),Wo(tp,n,Dr,Nr,W,Rt,null));let{left:gt,top:Mt,width:Ut,height:Ft}=Ve;wd=gt,bd=Mt,Ed=Ut,Td=Ft}function Rd(w,C,U,z,j,nt,dt){Ps=Ln._x=Ln._y=!1,Vh(w,C,U,z,j,nt,dt,!1,!0);let{left:gt,top:Mt,width:Ut,height:Ft}=Ve,Bt=Ut>0||Ft>0,oe=wd!=gt||bd!=Mt||Ed!=Ut||Td!=Ft;if(Bt&&oe&&Ka(Ve),Ln.setScale&&Bt&&oe){let Ee=gt,we=Ut,_e=Mt,Qt=Ft;if(M.ori==1&&(Ee=Mt,we=Ft,_e=gt,Qt=Ut),En&&Is(A,Xi(Ee,A),Xi(Ee+we,A)),Tn)for(let Xt in S){let Ge=S[Xt];Xt!=A&&Ge.from==null&&Ge.min!=Fe&&Is(Xt,Xi(_e+Qt,Xt),Xi(_e,Xt))}Hh()}else $.lock&&($._lock=!$._lock,ir(C,!0,w!=null));w!=null&&(hn(Qh,su),Wo(Qh,n,ze,Ze,W,Rt,null))}function h_(w,C,U,z,j,nt,dt){if($._lock)return;te(w);let gt=Ps;if(Ps){let Mt=!0,Ut=!0,Ft=10,Bt,oe;M.ori==0?(Bt=En,oe=Tn):(Bt=Tn,oe=En),Bt&&oe&&(Mt=ze<=Ft||ze>=W-Ft,Ut=Ze<=Ft||Ze>=Rt-Ft),Bt&&Mt&&(ze=ze<Dr?0:W),oe&&Ut&&(Ze=Ze<Nr?0:Rt),ir(null,!0,!0),Ps=!1}ze=-10,Ze=-10,H.fill(null),ir(null,!0,!0),gt&&(Ps=gt)}function Cd(w,C,U,z,j,nt,dt){$._lock||(te(w),zo(),Hh(),w!=null&&Wo(ip,n,ze,Ze,W,Rt,null))}function Pd(){b.forEach(Ry),X(n.width,n.height,!0)}hr(hl,Hr,Pd);let Or={};Or.mousedown=Ad,Or.mousemove=Sd,Or.mouseup=Rd,Or.dblclick=Cd,Or.setSeries=(w,C,U,z)=>{let j=gn.match[2];U=j(n,C,U),U!=-1&&Wi(U,z,!0,!1)},it&&(fe(tp,m,Ad),fe(Kh,m,Sd),fe(ep,m,w=>{te(w),Ho(!1)}),fe(np,m,h_),fe(ip,m,Cd),fu.add(n),n.syncRect=Ho);let Qa=n.hooks=i.hooks||{};function An(w,C,U){zn?Ne.push([w,C,U]):w in Qa&&Qa[w].forEach(z=>{z.call(null,n,C,U)})}(i.plugins||[]).forEach(w=>{for(let C in w.hooks)Qa[C]=(Qa[C]||[]).concat(w.hooks[C])});let Id=(w,C,U)=>U,gn=_n({key:null,setSeries:!1,filters:{pub:pp,sub:pp},scales:[A,y[1]?y[1].scale:null],match:[mp,mp,Id],values:[null,null]},$.sync);gn.match.length==2&&gn.match.push(Id),$.sync=gn;let Ld=gn.key,Wh=um(Ld);function Wo(w,C,U,z,j,nt,dt){gn.filters.pub(w,C,U,z,j,nt,dt)&&Wh.pub(w,C,U,z,j,nt,dt)}Wh.sub(n);function u_(w,C,U,z,j,nt,dt){gn.filters.sub(w,C,U,z,j,nt,dt)&&Or[w](null,C,U,z,j,nt,dt)}n.pub=u_;function f_(){Wh.unsub(n),fu.delete(n),tn.clear(),au(hl,Hr,Pd),c.remove(),ot?.remove(),An("destroy")}n.destroy=f_;function Xh(){An("init",i,t),ko(t||i.data,!1),F[A]?Oh(A,F[A]):zo(),ct=Ve.show&&(Ve.width>0||Ve.height>0),at=_t=!0,X(i.width,i.height)}return y.forEach(Ar),b.forEach(ss),e?e instanceof HTMLElement?(e.appendChild(c),Xh()):e(n,Xh):Xh(),n}ln.assign=_n;ln.fmtNum=yu;ln.rangeNum=ul;ln.rangeLog=pl;ln.rangeAsinh=_u;ln.orient=fr;ln.pxRatio=Te;ln.join=yx;ln.fmtDate=Mu,ln.tzDate=Px;ln.sync=um;{ln.addGap=fy,ln.clipGaps=_l;let i=ln.paths={points:_m};i.linear=ym,i.stepped=my,i.bars=gy,i.spline=xy}var Cy=2048,Py=256,Ru=2,wm=["accent","flutter","divergent","ink"],bm=[{width:2},{width:1.5,dash:[6,4]},{width:1.5,dash:[2,3]},{width:1,dash:[10,3,2,3]}];function Tm({trace:i,phase:t,spectrum:e},n,s={length:[1,""],time:[1,""]}){let r=n.length,[o,a]=s.length,[l,c]=s.time,f=(v,M)=>M?`${v} in ${M}`:v,h=hs(),u=m(),p=new Map;function m(){return{t:[],q:n.map(()=>[]),v:[],off:[],ahead:[]}}let x=(v,M={})=>({label:v,labelSize:18,labelGap:0,stroke:()=>h.ink,font:"11px system-ui",labelFont:"12px system-ui",grid:{stroke:()=>h.line,width:1},ticks:{stroke:()=>h.line},...M}),g=v=>(M,L,I)=>L===null||L===I?[Math.min(0,L??0),(I??0)+v]:ln.rangeNum(L,I,.05,!0),d={legend:{show:!1},cursor:{show:!1}},y=new ln({...d,...Ml(i),scales:{x:{time:!1,range:g(100)},y:{range:g(.1)}},axes:[x(c?f("time",c):"time τ",{size:32}),x(f(n.join(", "),a),{size:50})],series:[{},...n.map((v,M)=>({...bm[M%bm.length],stroke:()=>h[wm[M%wm.length]]}))],hooks:{drawAxes:[A]}},[[],...n.map(()=>[])],i),b=new ln({...d,...Ml(t),scales:{x:{time:!1,range:()=>E(u.q[0])},y:{range:()=>E(u.v)}},axes:[x(f(n[0],a),{size:32}),x(f(`${n[0]}′`,a&&`${a}/${c}`),{size:50})],series:[{},{paths:()=>null,points:{show:!1}}],hooks:{draw:[_]}},[[0,1],[0,1]],t),S=new ln({...d,...Ml(e),scales:{x:{time:!1,range:()=>[0,c?Ru/(2*Math.PI*l):Ru]},y:{range:g(.1)}},axes:[x(c?`frequency in ${c==="s"?"Hz":`1/${c}`}`:"angular frequency",{size:32}),x(f(`amplitude of ${n[0]}`,a),{size:50})],series:[{},{stroke:()=>h.accent,width:1.5,fill:()=>h.three}]},[[],[]],e);function E(v){let[M,L]=v.length?[Math.min(...v),Math.max(...v)]:[-1,1],I=.08*(L-M)||.1;return[M-I,L+I]}function A(v){let{ctx:M,bbox:L}=v;M.save();for(let[I,D,F]of[[u.off,h.three,L.height],[u.ahead,h.divergent,6*devicePixelRatio]]){M.fillStyle=D;let G=null;I.forEach((k,tt)=>{if(G=k&&G===null?u.t[tt]:G,G!==null&&(!k||tt===I.length-1)){let[V,O]=[G,u.t[tt]].map(H=>v.valToPos(H,"x",!0));M.fillRect(Math.max(V,L.left),L.top,Math.max(1,O-Math.max(V,L.left)),F),G=null}})}M.restore()}function _(v){let{ctx:M,bbox:L}=v;M.save(),M.beginPath(),M.rect(L.left,L.top,L.width,L.height),M.clip();let I=u.v.length,D=F=>[v.valToPos(u.q[0][F],"x",!0),v.valToPos(u.v[F],"y",!0)];for(let F of[!1,!0]){M.beginPath(),M.strokeStyle=F?h.flutter:h.accent,M.setLineDash(F?[5*devicePixelRatio,3*devicePixelRatio]:[]),M.lineWidth=1.5*devicePixelRatio;for(let G=1;G<I;G++)u.off[G]===F&&((G===1||u.off[G-1]!==F)&&M.moveTo(...D(G-1)),M.lineTo(...D(G)));M.stroke()}I&&(M.setLineDash([]),M.fillStyle=h.ink,M.beginPath(),M.arc(...D(I-1),4*devicePixelRatio,0,7),M.fill()),M.restore()}function T(){let v=2**Math.floor(Math.log2(Math.max(1,u.v.length)));if(v<Py)return[[],[]];p.has(v)||p.set(v,new Em.default(v));let M=p.get(v),L=M.createComplexArray(),I=u.q[0].slice(-v),D=I.reduce((k,tt)=>k+tt,0)/v;M.realTransform(L,I.map((k,tt)=>(k-D)*(.5-.5*Math.cos(2*Math.PI*tt/v))));let F=2*Math.PI/(v*(u.t.at(-1)-u.t.at(-2))),G=Array.from({length:Math.min(v/2,Math.ceil(Ru/l/F))},(k,tt)=>tt);return[G.map(k=>c?k*F/(2*Math.PI):k*F),G.map(k=>4/v*Math.hypot(L[2*k],L[2*k+1]))]}function B(v){y.setData([u.t,...u.q]),b.redraw(!1,!0),b.setData([[0,1],[0,1]]),v&&S.setData(T())}return{add(v,M,{contact:L,side:I}){u.q.forEach((F,G)=>F.push(o*M[G]));let D={t:l*v,v:o/l*M[r],off:!L,ahead:I<0};Object.entries(D).forEach(([F,G])=>u[F].push(G)),u.v.length>Cy&&[...u.q,u.t,u.v,u.off,u.ahead].forEach(F=>F.shift())},clear(){u=m(),B(!0)},draw:B,resize(){[[y,i],[b,t],[S,e]].forEach(([v,M])=>v.setSize(Ml(M)))},recolour(){h=hs(),[y,b,S].forEach(v=>v.redraw())}}}function Ml(i){return{width:Math.max(240,i.clientWidth),height:Math.max(160,i.clientHeight)}}function Am(i){let[t,e,n,s,r,o,a]=[null,[],0,!1,0,0,10],l=2;function c(p){t=p,l=e.length?t.pieces(e,.1,.05):l}function f(p){[e,n,o]=[p,0,0],l=t.pieces(e,.1,.05),i.sample(n,e,t.regime(e)),i.frame(n,e,t.regime(e))}function h(){for(let p=0;p<l;p++)e=t.step(e,.1/l);n+=.1,i.sample(n,e,t.regime(e))}function u(p){if(!s)return;o=Math.min(o+(p-r)/1e3*a,.5*a),r=p;let m=performance.now()+10;try{for(;o>=.1&&performance.now()<m;)h(),o-=.1}catch{s=!1,i.stop();return}i.frame(n,e,t.regime(e)),requestAnimationFrame(u)}return{set:c,start:f,play(){s||(s=!0,r=performance.now(),requestAnimationFrame(u))},pause(){s=!1},running:()=>s,pace(p){a=p},state:()=>e}}var Xe=i=>document.getElementById(i),[Iy,Ly]=[2,16],Rm="The motion can't go on from here: a spring has no length, or the numbers leave double precision. Choose another start.";function Cm(i,t,e,n){let s=Tm({trace:Xe("trace"),phase:Xe("phase"),spectrum:Xe("spectrum")},i,e),r=[...i.map(b=>({id:`${b}0`,symbol:b,meaning:`${b} at the start`,value:0})),...i.map(b=>({id:`v${b}0`,symbol:`${b}′`,meaning:`rate of ${b} at the start`,value:0}))],o=[],[a,l,c]=[!1,0,!1],f=Am({sample:s.add,frame:h,stop:()=>{Xe("motion_says").textContent=Rm,u()}});[...r,...t].forEach(({id:b,symbol:S,meaning:E,value:A})=>{let _=document.createElement("label");_.innerHTML=`${S} <input id="${b}" type="text" inputmode="decimal" autocomplete="off" aria-label="${E}">`;let T=_.firstElementChild;T.value=us(A),Xe("starts").append(_),n.beside&&(_.append(document.createElement("i")),o.push(()=>_.lastElementChild.textContent=n.beside(b,Ns(T.value))),T.addEventListener("input",o.at(-1)))});function h(b,S,E){l+=1;let[A,_]=[!E.contact,E.side<0];n.frame(b,S,E),Xe("motion_says").textContent=`${A?"off the belt":"on the belt"}, ${_?"faster than the belt":"slower than the belt"}`,l%Iy===0&&s.draw(l%Ly===0)}function u(){Xe("play").textContent=f.running()?"Pause":"Run",Xe("play").setAttribute("aria-pressed",String(f.running())),Xe("still").disabled=!a}function p(b){let S={};for(let{id:E,symbol:A,range:_}of b){let T=Xe(E),B=Ns(T.value),v=il({symbol:A},B,T.value,_);if(T.setAttribute("aria-invalid",String(!!v)),v)return Xe("motion_says").textContent=v,null;S[E]=B}return S}function m(b,S){f.set(n.field(S)),s.clear(),[a,c]=[!0,!0],Xe("motion_says").textContent="";try{f.start(b),f.play()}catch{Xe("motion_says").textContent=Rm}n.begun(S),u()}function x(){let[b,S]=[p(r),p(t)];b&&S&&m(Object.values(b),S)}function g(b){r.forEach(({id:S},E)=>Xe(S).value=us(b[E],8)),o.forEach(S=>S())}function d(b,S){f.pause(),a=!0,g([...b,...b.map(()=>0)]),S&&x(),u()}function y(){f.pause(),[a,c]=[!1,!1],Xe("motion_says").textContent="",n.rest(),u()}return Xe("play").onclick=()=>{f.running()?f.pause():a&&c?f.play():x(),u()},Xe("restart").onclick=x,Xe("still").onclick=y,Xe("from_state").onclick=()=>{let b=n.state();b&&(g([b[0]+.01,...b.slice(1),...b.map(()=>0)]),x())},Xe("pace").oninput=()=>{f.pace(Number(Xe("pace").value)),Xe("pace_says").textContent=`${Xe("pace").value} units of τ a second`},Xe("pace").oninput(),u(),{hold:d,still:y,numbersOf:()=>p(t),moving:()=>a,changed:()=>{let b=a?p(t):null;b&&f.set(n.field(b))},put:b=>{Object.entries(b).forEach(([S,E])=>Xe(S).value=us(E)),o.forEach(S=>S())},resize:s.resize,recolour:s.recolour}}function Sl(i){let t=document.createElement("canvas");t.className="overlay",t.setAttribute("aria-hidden","true"),i.append(t);let e=t.getContext("2d"),n="";function s(){let[r,o]=[i.clientWidth,i.clientHeight];return n!==`${r} ${o} ${devicePixelRatio}`&&(n=`${r} ${o} ${devicePixelRatio}`,[t.width,t.height]=[Math.round(r*devicePixelRatio),Math.round(o*devicePixelRatio)]),[r,o]}return function(o){let[a,l]=s();e.setTransform(devicePixelRatio,0,0,devicePixelRatio,0,0),e.clearRect(0,0,a,l),e.setLineDash([]),o(e,a,l)}}var Pm=.01,Dy={ArrowLeft:[-.5,0],ArrowRight:[.5,0],ArrowDown:[0,-.005],ArrowUp:[0,.005]};function Lm(i,t){let[e,n,s]=[1,null,hs()],r=document.createElement("div");r.id="point",r.tabIndex=0,r.setAttribute("role","slider"),r.setAttribute("aria-label","The point in the plane of inclination and friction; arrow keys move it, with Shift in larger steps");let o=new ln({...Im(i),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>[0,180]},y:{range:()=>[0,e]}},axes:[l("θ₀ in degrees",34,{splits:()=>[0,30,60,90,120,150,180]}),l("friction μ₀",46)],series:[{},{paths:()=>null,points:{show:!1}}],hooks:{drawAxes:[h],draw:[p]}},[[0,180],[0,1]],i),a=Sl(o.over);o.over.append(r);function l(E,A,_={}){return{label:E,labelSize:18,size:A,labelGap:0,stroke:()=>s.ink,font:"12px system-ui",labelFont:"13px system-ui",grid:{stroke:()=>s.line,width:1},ticks:{stroke:()=>s.line},..._}}let c=(E,A)=>[o.valToPos(Je(E),"x",!0),o.valToPos(A,"y",!0)];function f(E){let{ctx:A,bbox:_}=o;A.save(),A.beginPath(),A.rect(_.left,_.top,_.width,_.height),A.clip(),E(A,devicePixelRatio),A.restore()}function h(){n&&f(E=>{let A=Math.PI/n.strips.columns;E.fillStyle=s.three;for(let{i:_,low:T,high:B}of n.strips.found){let[[v,M],[L,I]]=[c(_*A,T),c((_+1)*A,Math.min(B,e))];E.fillRect(Math.floor(v),I,Math.ceil(L)-Math.floor(v),M-I)}})}function u(E,{theta0:A,mu0:_}){E.beginPath(),A.forEach((T,B)=>E[B?"lineTo":"moveTo"](...c(T,_[B]))),E.stroke()}function p(){n&&f((E,A)=>{E.lineWidth=2*A,E.strokeStyle=s.ink,n.curves.forEach(_=>u(E,_)),E.setLineDash([7*A,4*A]),E.strokeStyle=s.flutter,n.flutter.forEach(_=>u(E,_)),E.setLineDash([]),E.font=`600 ${13*A}px system-ui`,E.fillStyle=s.ink,E.textAlign="left";for(let{theta0:_,mu0:T}of n.cusps.filter(B=>B.mu0<e)){let[B,v]=c(_,T);E.beginPath(),E.arc(B,v,4.5*A,0,7),E.fill(),E.fillText("cusp",B+8*A,v+4*A)}m(E,A),x(E,A)})}function m(E,A){let{theta0:_,mu0:T,kind:B}=n.lowest;if(B&&B!=="cusp"&&T<e){let[[v,M],L]=[c(_,T),5.5*A];E.beginPath(),[[0,-L],[L,0],[0,L],[-L,0]].forEach(([I,D],F)=>E[F?"lineTo":"moveTo"](v+I,M+D)),E.closePath(),E.lineWidth=2*A,E.strokeStyle=s.ink,E.stroke(),E.textBaseline="top",E.fillText("lowest fold",v+4*A,M+6*A),E.textBaseline="alphabetic"}}function x(E,A){let{columns:_,found:T}=n.strips;E.fillStyle=s.ink,E.strokeStyle=s.three,E.lineWidth=4*A,E.lineJoin="round",E.font=`${12*A}px system-ui`,E.textAlign="center";for(let B of[0,1]){let v=T.filter(({i:M,low:L,high:I})=>Math.floor(2*M/_)===B&&Math.min(I,e)-L>.5*e);if(v.length>.1*_){let{i:M,count:L}=v[Math.floor(v.length/2)],[I,{left:D,width:F}]=[`${L} states`,o.bbox],[G,k]=c(Math.PI*(M+.5)/_,.3*e),tt=E.measureText(I).width/2+3*A,V=Math.min(D+F-tt,Math.max(D+tt,G));E.strokeText(I,V,k),E.fillText(I,V,k)}}E.textAlign="left"}function g(){let{path:E}=t.get()??{path:[]},A=({theta0:_,mu0:T})=>[o.valToPos(Je(_),"x"),o.valToPos(T,"y")];a(_=>{_.strokeStyle=s.path,_.lineWidth=2,_.beginPath(),E.forEach((T,B)=>_[B?"lineTo":"moveTo"](...A(T))),_.stroke(),_.strokeStyle=s.jump,_.lineWidth=2.5,_.beginPath();for(let T of E.filter(({jump:B})=>B)){let[[B,v],M]=[A(T),6];[[-M,-M,M,M],[-M,M,M,-M]].forEach(([L,I,D,F])=>{_.moveTo(B+L,v+I),_.lineTo(B+D,v+F)})}_.stroke()})}function d(E,A){let _=Math.min(180-Pm,Math.max(Pm,E));t.move({theta0:$i(_),mu0:Math.min(e,Math.max(0,A))})}let y=null;function b(E){let{left:A,top:_}=o.over.getBoundingClientRect(),T=y===null;y=[o.posToVal(E.clientX-A,"x"),o.posToVal(E.clientY-_,"y")],T&&requestAnimationFrame(()=>{let[B,v]=y;y=null,d(B,v)})}o.over.addEventListener("pointerdown",E=>{o.over.setPointerCapture(E.pointerId),r.focus({preventScroll:!0}),b(E),E.preventDefault()}),o.over.addEventListener("pointermove",E=>o.over.hasPointerCapture(E.pointerId)&&b(E)),r.addEventListener("keydown",E=>{let A=Dy[E.key];if(A){E.preventDefault();let{theta0:_,mu0:T}=t.get().point,B=E.shiftKey?10:1;d(Je(_)+B*A[0],T+B*A[1]*e)}});function S(){let{point:E,found:A}=t.get();g(),r.style.left=`${o.valToPos(Je(E.theta0),"x")}px`,r.style.top=`${o.valToPos(Math.min(E.mu0,e),"y")}px`;let _=`inclination ${He(Je(E.theta0),5)} degrees, friction ${He(E.mu0,4)}, ${A.contact.count} equilibria in contact`;r.setAttribute("aria-valuetext",_),r.setAttribute("aria-valuenow",Je(E.theta0).toFixed(2)),r.setAttribute("aria-valuemin","0"),r.setAttribute("aria-valuemax","180")}return{draw:S,show:E=>{n=E,o.redraw(!1)},reach:E=>{e=E,o.redraw(!0)},resize:()=>{o.setSize(Im(i)),S()},recolour:()=>{s=hs(),o.redraw(!1),S()}}}var Ny={cusp:"a cusp",turn:"where the curve of folds turns back",end:"as θ₀ goes to 0"};function Dm(i){if(!i)return"";let{theta0:t,mu0:e,kind:n}=i.lowest;return n?`Lowest fold that ends the state of small deformation: μ₀ = ${He(e,6)} at θ₀ = ${He(Je(t),5)}°, ${Ny[n]}. Below that friction it jumps at no inclination (in double precision, not proved).`:"No fold ends the state of small deformation, at any inclination and friction (in double precision, not proved)."}function Im(i){return{width:Math.max(260,i.clientWidth),height:Math.max(220,i.clientHeight)}}var js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Zs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},cg=0,rf=1,hg=2;var Fa=1,ug=2,To=3,Js=0,jn=1,wi=2,vr=0,Ao=1,of=2,af=3,lf=4,fg=5;var Mr=100,dg=101,pg=102,mg=103,gg=104,_g=200,xg=201,yg=202,vg=203,cf=204,hf=205,Mg=206,Sg=207,wg=208,bg=209,Eg=210,Tg=211,Ag=212,Rg=213,Cg=214,Zl=0,Jl=1,Kl=2,go=3,Ql=4,tc=5,ec=6,nc=7,Pc=0,Pg=1,Ig=2,es=0,uf=1,ff=2,df=3,pf=4,mf=5,gf=6,_f=7;var xf=300,Sr=301,Ro=302,Ic=303,Lc=304,ic=1e3,Ji=1001,sc=1002,Pn=1003,Lg=1004;var Oa=1005;var Yn=1006,Dc=1007;var bs=1008;var Qn=1009,yf=1010,vf=1011,Co=1012,Nc=1013,Fi=1014,Oi=1015,Bi=1016,Uc=1017,Fc=1018,wr=1020,Mf=35902,Sf=35899,wf=1021,bf=1022,ki=1023,Ms=1026,Es=1027,Ef=1028,Oc=1029,Ks=1030,Bc=1031;var kc=1033,Ba=33776,ka=33777,za=33778,Va=33779,zc=35840,Vc=35841,Gc=35842,Hc=35843,Wc=36196,Xc=37492,qc=37496,Yc=37488,$c=37489,Ga=37490,jc=37491,Zc=37808,Jc=37809,Kc=37810,Qc=37811,th=37812,eh=37813,nh=37814,ih=37815,sh=37816,rh=37817,oh=37818,ah=37819,lh=37820,ch=37821,hh=36492,uh=36494,fh=36495,dh=36283,ph=36284,Ha=36285,mh=36286;var ha=2300,rc=2301,$l=2302,Ju=2303,Ku=2400,Qu=2401,tf=2402;var Dg=3200;var gh=0,Ng=1,Ts="",hi="srgb",ua="srgb-linear",fa="linear",Pe="srgb";var jl=7680;var Ug=519,Fg=512,Og=513,Bg=514,Tf=515,kg=516,zg=517,Af=518,Rf=519,Cf=35044;var Pf="300 es",Mi=2e3,_o=2001;function Uy(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Fy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function da(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Vg(){let i=da("canvas");return i.style.display="block",i}var Nm={},xo=null;function pa(...i){let t="THREE."+i.shift();xo?xo("log",t,...i):console.log(t,...i)}function Gg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Kt(...i){i=Gg(i);let t="THREE."+i.shift();if(xo)xo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ne(...i){i=Gg(i);let t="THREE."+i.shift();if(xo)xo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function aa(...i){let t=i.join(" ");t in Nm||(Nm[t]=!0,Kt(...i))}function Hg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Wg={[Zl]:Zl,[Kl]:ec,[Ql]:Ql,[go]:tc,[Jl]:Jl,[ec]:Kl,[nc]:nc,[tc]:go},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Um=1234567,la=Math.PI/180,yo=180/Math.PI;function Qs(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]).toLowerCase()}function me(i,t,e){return Math.max(t,Math.min(e,i))}function If(i,t){return(i%t+t)%t}function Oy(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function By(i,t,e){return i!==t?(e-i)/(t-i):0}function ca(i,t,e){return(1-e)*i+e*t}function ky(i,t,e,n){return ca(i,t,1-Math.exp(-e*n))}function zy(i,t=1){return t-Math.abs(If(i,t*2)-t)}function Vy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Gy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Hy(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Wy(i,t){return i+Math.random()*(t-i)}function Xy(i){return i*(.5-Math.random())}function qy(i){i!==void 0&&(Um=i);let t=Um+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Yy(i){return i*la}function $y(i){return i*yo}function jy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Zy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Lf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Jy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),f=o((t+n)/2),h=r((t-n)/2),u=o((t-n)/2),p=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*f,l*h,l*u,a*c);break;case"YZY":i.set(l*u,a*f,l*h,a*c);break;case"ZXZ":i.set(l*h,l*u,a*f,a*c);break;case"XZX":i.set(a*f,l*m,l*p,a*c);break;case"YXY":i.set(l*p,a*f,l*m,a*c);break;case"ZYZ":i.set(l*m,l*p,a*f,a*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function _h(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Df(i,t){if(t.constructor===Float32Array)return i;let e=_h(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Nf(i,t){if(t.constructor===Float32Array)return i;let e=_h(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Uf={DEG2RAD:la,RAD2DEG:yo,generateUUID:Qs,clamp:me,euclideanModulo:If,mapLinear:Oy,inverseLerp:By,lerp:ca,damp:ky,pingpong:zy,smoothstep:Vy,smootherstep:Gy,randInt:Hy,randFloat:Wy,randFloatSpread:Xy,seededRandom:qy,degToRad:Yy,radToDeg:$y,isPowerOfTwo:jy,ceilPowerOfTwo:Zy,floorPowerOfTwo:Lf,setQuaternionFromProperEuler:Jy,normalize:Nf,denormalize:Df},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(me(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fi=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],f=n[s+2],h=n[s+3],u=r[o+0],p=r[o+1],m=r[o+2],x=r[o+3];if(h!==x||l!==u||c!==p||f!==m){let g=l*u+c*p+f*m+h*x;g<0&&(u=-u,p=-p,m=-m,x=-x,g=-g);let d=1-a;if(g<.9995){let y=Math.acos(g),b=Math.sin(y);d=Math.sin(d*y)/b,a=Math.sin(a*y)/b,l=l*d+u*a,c=c*d+p*a,f=f*d+m*a,h=h*d+x*a}else{l=l*d+u*a,c=c*d+p*a,f=f*d+m*a,h=h*d+x*a;let y=1/Math.sqrt(l*l+c*c+f*f+h*h);l*=y,c*=y,f*=y,h*=y}}t[e]=l,t[e+1]=c,t[e+2]=f,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],f=n[s+3],h=r[o],u=r[o+1],p=r[o+2],m=r[o+3];return t[e]=a*m+f*h+l*p-c*u,t[e+1]=l*m+f*u+c*h-a*p,t[e+2]=c*m+f*p+a*u-l*h,t[e+3]=f*m-a*h-l*u-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),f=a(s/2),h=a(r/2),u=l(n/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=u*f*h+c*p*m,this._y=c*p*h-u*f*m,this._z=c*f*m+u*p*h,this._w=c*f*h-u*p*m;break;case"YXZ":this._x=u*f*h+c*p*m,this._y=c*p*h-u*f*m,this._z=c*f*m-u*p*h,this._w=c*f*h+u*p*m;break;case"ZXY":this._x=u*f*h-c*p*m,this._y=c*p*h+u*f*m,this._z=c*f*m+u*p*h,this._w=c*f*h-u*p*m;break;case"ZYX":this._x=u*f*h-c*p*m,this._y=c*p*h+u*f*m,this._z=c*f*m-u*p*h,this._w=c*f*h+u*p*m;break;case"YZX":this._x=u*f*h+c*p*m,this._y=c*p*h+u*f*m,this._z=c*f*m-u*p*h,this._w=c*f*h-u*p*m;break;case"XZY":this._x=u*f*h-c*p*m,this._y=c*p*h-u*f*m,this._z=c*f*m+u*p*h,this._w=c*f*h+u*p*m;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],f=e[6],h=e[10],u=n+a+h;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(f-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>h){let p=2*Math.sqrt(1+n-a-h);this._w=(f-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-n-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+f)/p}else{let p=2*Math.sqrt(1+h-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+f)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(me(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,f=e._w;return this._x=n*f+o*a+s*c-r*l,this._y=s*f+o*l+r*a-n*c,this._z=r*f+o*c+n*l-s*a,this._w=o*f-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),f=Math.sin(c);l=Math.sin(l*c)/f,e=Math.sin(e*c)/f,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Fm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Fm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),f=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*f,this.y=n+l*f+a*c-r*h,this.z=s+l*h+r*f-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Cu.copy(this).projectOnVector(t),this.sub(Cu)}reflect(t){return this.sub(Cu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(me(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Cu=new K,Fm=new fi,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let f=this.elements;return f[0]=t,f[1]=s,f[2]=a,f[3]=e,f[4]=r,f[5]=l,f[6]=n,f[7]=o,f[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],f=n[4],h=n[7],u=n[2],p=n[5],m=n[8],x=s[0],g=s[3],d=s[6],y=s[1],b=s[4],S=s[7],E=s[2],A=s[5],_=s[8];return r[0]=o*x+a*y+l*E,r[3]=o*g+a*b+l*A,r[6]=o*d+a*S+l*_,r[1]=c*x+f*y+h*E,r[4]=c*g+f*b+h*A,r[7]=c*d+f*S+h*_,r[2]=u*x+p*y+m*E,r[5]=u*g+p*b+m*A,r[8]=u*d+p*S+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8];return e*o*f-e*a*c-n*r*f+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],h=f*o-a*c,u=a*l-f*r,p=c*r-o*l,m=e*h+n*u+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return t[0]=h*x,t[1]=(s*c-f*n)*x,t[2]=(a*n-s*o)*x,t[3]=u*x,t[4]=(f*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Pu.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Pu.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Pu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Pu=new re,Om=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Bm=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ky(){let i={enabled:!0,workingColorSpace:ua,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=vs(s.r),s.g=vs(s.g),s.b=vs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=mo(s.r),s.g=mo(s.g),s.b=mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ua]:{primaries:t,whitePoint:n,transfer:fa,toXYZ:Om,fromXYZ:Bm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:hi},outputColorSpaceConfig:{drawingBufferColorSpace:hi}},[hi]:{primaries:t,whitePoint:n,transfer:Pe,toXYZ:Om,fromXYZ:Bm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:hi}}}),i}var ve=Ky();function vs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function mo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Jr,oc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Jr===void 0&&(Jr=da("canvas")),Jr.width=t.width,Jr.height=t.height;let s=Jr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Jr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=da("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=vs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(vs(e[n]/255)*255):e[n]=vs(e[n]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Qy=0,vo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Qy++}),this.uuid=Qs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Iu(s[o].image)):r.push(Iu(s[o]))}else r=Iu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Iu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?oc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var tv=0,Lu=new K,$n=class i extends Ui{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Ji,s=Ji,r=Yn,o=bs,a=ki,l=Qn,c=i.DEFAULT_ANISOTROPY,f=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=Qs(),this.name="",this.source=new vo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=f,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Lu).x}get height(){return this.source.getSize(Lu).y}get depth(){return this.source.getSize(Lu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==xf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ic:t.x=t.x-Math.floor(t.x);break;case Ji:t.x=t.x<0?0:1;break;case sc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ic:t.y=t.y-Math.floor(t.y);break;case Ji:t.y=t.y<0?0:1;break;case sc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};$n.DEFAULT_IMAGE=null;$n.DEFAULT_MAPPING=xf;$n.DEFAULT_ANISOTROPY=1;var Ke=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],f=l[4],h=l[8],u=l[1],p=l[5],m=l[9],x=l[2],g=l[6],d=l[10];if(Math.abs(f-u)<.01&&Math.abs(h-x)<.01&&Math.abs(m-g)<.01){if(Math.abs(f+u)<.1&&Math.abs(h+x)<.1&&Math.abs(m+g)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,S=(p+1)/2,E=(d+1)/2,A=(f+u)/4,_=(h+x)/4,T=(m+g)/4;return b>S&&b>E?b<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(b),s=A/n,r=_/n):S>E?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=A/s,r=T/s):E<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),n=_/r,s=T/r),this.set(n,s,r,e),this}let y=Math.sqrt((g-m)*(g-m)+(h-x)*(h-x)+(u-f)*(u-f));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(h-x)/y,this.z=(u-f)/y,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this.w=me(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this.w=me(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ac=class extends Ui{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ke(0,0,t,e),this.scissorTest=!1,this.viewport=new Ke(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new $n({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new vo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends ac{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ma=class extends $n{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var lc=class extends $n{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Be=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,f,h,u,p,m,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,f,h,u,p,m,x,g)}set(t,e,n,s,r,o,a,l,c,f,h,u,p,m,x,g){let d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=f,d[10]=h,d[14]=u,d[3]=p,d[7]=m,d[11]=x,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Kr.setFromMatrixColumn(t,0).length(),r=1/Kr.setFromMatrixColumn(t,1).length(),o=1/Kr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),f=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let u=o*f,p=o*h,m=a*f,x=a*h;e[0]=l*f,e[4]=-l*h,e[8]=c,e[1]=p+m*c,e[5]=u-x*c,e[9]=-a*l,e[2]=x-u*c,e[6]=m+p*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*f,p=l*h,m=c*f,x=c*h;e[0]=u+x*a,e[4]=m*a-p,e[8]=o*c,e[1]=o*h,e[5]=o*f,e[9]=-a,e[2]=p*a-m,e[6]=x+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*f,p=l*h,m=c*f,x=c*h;e[0]=u-x*a,e[4]=-o*h,e[8]=m+p*a,e[1]=p+m*a,e[5]=o*f,e[9]=x-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*f,p=o*h,m=a*f,x=a*h;e[0]=l*f,e[4]=m*c-p,e[8]=u*c+x,e[1]=l*h,e[5]=x*c+u,e[9]=p*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,p=o*c,m=a*l,x=a*c;e[0]=l*f,e[4]=x-u*h,e[8]=m*h+p,e[1]=h,e[5]=o*f,e[9]=-a*f,e[2]=-c*f,e[6]=p*h+m,e[10]=u-x*h}else if(t.order==="XZY"){let u=o*l,p=o*c,m=a*l,x=a*c;e[0]=l*f,e[4]=-h,e[8]=c*f,e[1]=u*h+x,e[5]=o*f,e[9]=p*h-m,e[2]=m*h-p,e[6]=a*f,e[10]=x*h+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(ev,t,nv)}lookAt(t,e,n){let s=this.elements;return li.subVectors(t,e),li.lengthSq()===0&&(li.z=1),li.normalize(),ks.crossVectors(n,li),ks.lengthSq()===0&&(Math.abs(n.z)===1?li.x+=1e-4:li.z+=1e-4,li.normalize(),ks.crossVectors(n,li)),ks.normalize(),wl.crossVectors(li,ks),s[0]=ks.x,s[4]=wl.x,s[8]=li.x,s[1]=ks.y,s[5]=wl.y,s[9]=li.y,s[2]=ks.z,s[6]=wl.z,s[10]=li.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],f=n[1],h=n[5],u=n[9],p=n[13],m=n[2],x=n[6],g=n[10],d=n[14],y=n[3],b=n[7],S=n[11],E=n[15],A=s[0],_=s[4],T=s[8],B=s[12],v=s[1],M=s[5],L=s[9],I=s[13],D=s[2],F=s[6],G=s[10],k=s[14],tt=s[3],V=s[7],O=s[11],H=s[15];return r[0]=o*A+a*v+l*D+c*tt,r[4]=o*_+a*M+l*F+c*V,r[8]=o*T+a*L+l*G+c*O,r[12]=o*B+a*I+l*k+c*H,r[1]=f*A+h*v+u*D+p*tt,r[5]=f*_+h*M+u*F+p*V,r[9]=f*T+h*L+u*G+p*O,r[13]=f*B+h*I+u*k+p*H,r[2]=m*A+x*v+g*D+d*tt,r[6]=m*_+x*M+g*F+d*V,r[10]=m*T+x*L+g*G+d*O,r[14]=m*B+x*I+g*k+d*H,r[3]=y*A+b*v+S*D+E*tt,r[7]=y*_+b*M+S*F+E*V,r[11]=y*T+b*L+S*G+E*O,r[15]=y*B+b*I+S*k+E*H,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],f=t[2],h=t[6],u=t[10],p=t[14],m=t[3],x=t[7],g=t[11],d=t[15],y=l*p-c*u,b=a*p-c*h,S=a*u-l*h,E=o*p-c*f,A=o*u-l*f,_=o*h-a*f;return e*(x*y-g*b+d*S)-n*(m*y-g*E+d*A)+s*(m*b-x*E+d*_)-r*(m*S-x*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],f=t[10];return e*(o*f-a*c)-n*(r*f-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],h=t[9],u=t[10],p=t[11],m=t[12],x=t[13],g=t[14],d=t[15],y=e*a-n*o,b=e*l-s*o,S=e*c-r*o,E=n*l-s*a,A=n*c-r*a,_=s*c-r*l,T=f*x-h*m,B=f*g-u*m,v=f*d-p*m,M=h*g-u*x,L=h*d-p*x,I=u*d-p*g,D=y*I-b*L+S*M+E*v-A*B+_*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let F=1/D;return t[0]=(a*I-l*L+c*M)*F,t[1]=(s*L-n*I-r*M)*F,t[2]=(x*_-g*A+d*E)*F,t[3]=(u*A-h*_-p*E)*F,t[4]=(l*v-o*I-c*B)*F,t[5]=(e*I-s*v+r*B)*F,t[6]=(g*S-m*_-d*b)*F,t[7]=(f*_-u*S+p*b)*F,t[8]=(o*L-a*v+c*T)*F,t[9]=(n*v-e*L-r*T)*F,t[10]=(m*A-x*S+d*y)*F,t[11]=(h*S-f*A-p*y)*F,t[12]=(a*B-o*M-l*T)*F,t[13]=(e*M-n*B+s*T)*F,t[14]=(x*b-m*E-g*y)*F,t[15]=(f*E-h*b+u*y)*F,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,f=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,f*a+n,f*l-s*o,0,c*l-s*a,f*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,f=o+o,h=a+a,u=r*c,p=r*f,m=r*h,x=o*f,g=o*h,d=a*h,y=l*c,b=l*f,S=l*h,E=n.x,A=n.y,_=n.z;return s[0]=(1-(x+d))*E,s[1]=(p+S)*E,s[2]=(m-b)*E,s[3]=0,s[4]=(p-S)*A,s[5]=(1-(u+d))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(m+b)*_,s[9]=(g-y)*_,s[10]=(1-(u+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Kr.set(s[0],s[1],s[2]).length(),a=Kr.set(s[4],s[5],s[6]).length(),l=Kr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Li.copy(this);let c=1/o,f=1/a,h=1/l;return Li.elements[0]*=c,Li.elements[1]*=c,Li.elements[2]*=c,Li.elements[4]*=f,Li.elements[5]*=f,Li.elements[6]*=f,Li.elements[8]*=h,Li.elements[9]*=h,Li.elements[10]*=h,e.setFromRotationMatrix(Li),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Mi,l=!1){let c=this.elements,f=2*r/(e-t),h=2*r/(n-s),u=(e+t)/(e-t),p=(n+s)/(n-s),m,x;if(l)m=r/(o-r),x=o*r/(o-r);else if(a===Mi)m=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===_o)m=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Mi,l=!1){let c=this.elements,f=2/(e-t),h=2/(n-s),u=-(e+t)/(e-t),p=-(n+s)/(n-s),m,x;if(l)m=1/(o-r),x=o/(o-r);else if(a===Mi)m=-2/(o-r),x=-(o+r)/(o-r);else if(a===_o)m=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Kr=new K,Li=new Be,ev=new K(0,0,0),nv=new K(1,1,1),ks=new K,wl=new K,li=new K,km=new Be,zm=new fi,Ss=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],f=s[9],h=s[2],u=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(me(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-f,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-me(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(me(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-me(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(me(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-f,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-me(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-f,p),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return km.makeRotationFromQuaternion(t),this.setFromRotationMatrix(km,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return zm.setFromEuler(this),this.setFromQuaternion(zm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ss.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},iv=0,Vm=new K,Qr=new fi,ps=new Be,bl=new K,Qo=new K,sv=new K,rv=new fi,Gm=new K(1,0,0),Hm=new K(0,1,0),Wm=new K(0,0,1),Xm={type:"added"},ov={type:"removed"},to={type:"childadded",child:null},Du={type:"childremoved",child:null},Dn=class i extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:iv++}),this.uuid=Qs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new K,e=new Ss,n=new fi,s=new K(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Be},normalMatrix:{value:new re}}),this.matrix=new Be,this.matrixWorld=new Be,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Qr.setFromAxisAngle(t,e),this.quaternion.multiply(Qr),this}rotateOnWorldAxis(t,e){return Qr.setFromAxisAngle(t,e),this.quaternion.premultiply(Qr),this}rotateX(t){return this.rotateOnAxis(Gm,t)}rotateY(t){return this.rotateOnAxis(Hm,t)}rotateZ(t){return this.rotateOnAxis(Wm,t)}translateOnAxis(t,e){return Vm.copy(t).applyQuaternion(this.quaternion),this.position.add(Vm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Gm,t)}translateY(t){return this.translateOnAxis(Hm,t)}translateZ(t){return this.translateOnAxis(Wm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ps.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?bl.copy(t):bl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Qo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ps.lookAt(Qo,bl,this.up):ps.lookAt(bl,Qo,this.up),this.quaternion.setFromRotationMatrix(ps),s&&(ps.extractRotation(s.matrixWorld),Qr.setFromRotationMatrix(ps),this.quaternion.premultiply(Qr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ne("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Xm),to.child=t,this.dispatchEvent(to),to.child=null):ne("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ov),Du.child=t,this.dispatchEvent(Du),Du.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ps.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ps.multiply(t.parent.matrixWorld)),t.applyMatrix4(ps),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Xm),to.child=t,this.dispatchEvent(to),to.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qo,t,sv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qo,rv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,f=l.length;c<f;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),f=o(t.images),h=o(t.shapes),u=o(t.skeletons),p=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),f.length>0&&(n.images=f),h.length>0&&(n.shapes=h),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let f=a[c];delete f.metadata,l.push(f)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new K(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _r=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},av={type:"move"},Mo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _r,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _r,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _r,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,n),d=this._getHandJoint(c,x);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.quaternion,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let f=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],u=f.position.distanceTo(h.position),p=.02,m=.005;c.inputState.pinching&&u>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(av)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new _r;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Xg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zs={h:0,s:0,l:0},El={h:0,s:0,l:0};function Nu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=hi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=If(t,1),e=me(e,0,1),n=me(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Nu(o,r,t+1/3),this.g=Nu(o,r,t),this.b=Nu(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=hi){function n(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=hi){let n=Xg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=vs(t.r),this.g=vs(t.g),this.b=vs(t.b),this}copyLinearToSRGB(t){return this.r=mo(t.r),this.g=mo(t.g),this.b=mo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=hi){return ve.workingToColorSpace(Fn.copy(this),t),Math.round(me(Fn.r*255,0,255))*65536+Math.round(me(Fn.g*255,0,255))*256+Math.round(me(Fn.b*255,0,255))}getHexString(t=hi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(Fn.copy(this),e);let n=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,f=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=f<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=f,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(Fn.copy(this),e),t.r=Fn.r,t.g=Fn.g,t.b=Fn.b,t}getStyle(t=hi){ve.workingToColorSpace(Fn.copy(this),t);let e=Fn.r,n=Fn.g,s=Fn.b;return t!==hi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(zs),this.setHSL(zs.h+t,zs.s+e,zs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(zs),t.getHSL(El);let n=ca(zs.h,El.h,e),s=ca(zs.s,El.s,e),r=ca(zs.l,El.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new he;he.NAMES=Xg;var _a=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ss,this.environmentIntensity=1,this.environmentRotation=new Ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Di=new K,ms=new K,Uu=new K,gs=new K,eo=new K,no=new K,qm=new K,Fu=new K,Ou=new K,Bu=new K,ku=new Ke,zu=new Ke,Vu=new Ke,ys=class i{constructor(t=new K,e=new K,n=new K){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Di.subVectors(t,e),s.cross(Di);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Di.subVectors(s,e),ms.subVectors(n,e),Uu.subVectors(t,e);let o=Di.dot(Di),a=Di.dot(ms),l=Di.dot(Uu),c=ms.dot(ms),f=ms.dot(Uu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let u=1/h,p=(c*l-a*f)*u,m=(o*f-a*l)*u;return r.set(1-p-m,m,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,gs)===null?!1:gs.x>=0&&gs.y>=0&&gs.x+gs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,gs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,gs.x),l.addScaledVector(o,gs.y),l.addScaledVector(a,gs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return ku.setScalar(0),zu.setScalar(0),Vu.setScalar(0),ku.fromBufferAttribute(t,e),zu.fromBufferAttribute(t,n),Vu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ku,r.x),o.addScaledVector(zu,r.y),o.addScaledVector(Vu,r.z),o}static isFrontFacing(t,e,n,s){return Di.subVectors(n,e),ms.subVectors(t,e),Di.cross(ms).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Di.subVectors(this.c,this.b),ms.subVectors(this.a,this.b),Di.cross(ms).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;eo.subVectors(s,n),no.subVectors(r,n),Fu.subVectors(t,n);let l=eo.dot(Fu),c=no.dot(Fu);if(l<=0&&c<=0)return e.copy(n);Ou.subVectors(t,s);let f=eo.dot(Ou),h=no.dot(Ou);if(f>=0&&h<=f)return e.copy(s);let u=l*h-f*c;if(u<=0&&l>=0&&f<=0&&l-f>0)return o=l/(l-f),e.copy(n).addScaledVector(eo,o);Bu.subVectors(t,r);let p=eo.dot(Bu),m=no.dot(Bu);if(m>=0&&p<=m)return e.copy(r);let x=p*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(no,a);let g=f*m-p*h;if(g<=0&&h-f>=0&&p-m>=0)return qm.subVectors(r,s),a=(h-f)/(h-f+(p-m)),e.copy(s).addScaledVector(qm,a);let d=1/(g+x+u);return o=x*d,a=u*d,e.copy(n).addScaledVector(eo,o).addScaledVector(no,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ws=class{constructor(t=new K(1/0,1/0,1/0),e=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ni.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ni.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ni.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(t.matrixWorld),this.expandByPoint(Ni);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Tl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Tl.copy(n.boundingBox)),Tl.applyMatrix4(t.matrixWorld),this.union(Tl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ni),Ni.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ta),Al.subVectors(this.max,ta),io.subVectors(t.a,ta),so.subVectors(t.b,ta),ro.subVectors(t.c,ta),Vs.subVectors(so,io),Gs.subVectors(ro,so),dr.subVectors(io,ro);let e=[0,-Vs.z,Vs.y,0,-Gs.z,Gs.y,0,-dr.z,dr.y,Vs.z,0,-Vs.x,Gs.z,0,-Gs.x,dr.z,0,-dr.x,-Vs.y,Vs.x,0,-Gs.y,Gs.x,0,-dr.y,dr.x,0];return!Gu(e,io,so,ro,Al)||(e=[1,0,0,0,1,0,0,0,1],!Gu(e,io,so,ro,Al))?!1:(Rl.crossVectors(Vs,Gs),e=[Rl.x,Rl.y,Rl.z],Gu(e,io,so,ro,Al))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ni).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ni).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(_s),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},_s=[new K,new K,new K,new K,new K,new K,new K,new K],Ni=new K,Tl=new Ws,io=new K,so=new K,ro=new K,Vs=new K,Gs=new K,dr=new K,ta=new K,Al=new K,Rl=new K,pr=new K;function Gu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){pr.fromArray(i,r);let a=s.x*Math.abs(pr.x)+s.y*Math.abs(pr.y)+s.z*Math.abs(pr.z),l=t.dot(pr),c=e.dot(pr),f=n.dot(pr);if(Math.max(-Math.max(l,c,f),Math.min(l,c,f))>a)return!1}return!0}var xn=new K,Cl=new Yt,lv=0,Kn=class extends Ui{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Cf,this.updateRanges=[],this.gpuType=Oi,this.version=0,this._normalizationScale=t!==void 0?_h(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Cl.fromBufferAttribute(this,e),Cl.applyMatrix3(t),this.setXY(e,Cl.x,Cl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyMatrix3(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyMatrix4(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyNormalMatrix(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.transformDirection(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Df(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Nf(t,this.array)}};var xa=class extends Kn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ya=class extends Kn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var ui=class extends Kn{constructor(t,e,n){super(new Float32Array(t),e,n)}},cv=new Ws,ea=new K,Hu=new K,xr=class{constructor(t=new K,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):cv.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ea.subVectors(t,this.center);let e=ea.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ea,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Hu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ea.copy(t.center).add(Hu)),this.expandByPoint(ea.copy(t.center).sub(Hu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},hv=0,vi=new Be,Wu=new Dn,oo=new K,ci=new Ws,na=new Ws,Cn=new K,pi=class i extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:hv++}),this.uuid=Qs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Uy(t)?ya:xa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vi.makeRotationFromQuaternion(t),this.applyMatrix4(vi),this}rotateX(t){return vi.makeRotationX(t),this.applyMatrix4(vi),this}rotateY(t){return vi.makeRotationY(t),this.applyMatrix4(vi),this}rotateZ(t){return vi.makeRotationZ(t),this.applyMatrix4(vi),this}translate(t,e,n){return vi.makeTranslation(t,e,n),this.applyMatrix4(vi),this}scale(t,e,n){return vi.makeScale(t,e,n),this.applyMatrix4(vi),this}lookAt(t){return Wu.lookAt(t),Wu.updateMatrix(),this.applyMatrix4(Wu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(oo).negate(),this.translate(oo.x,oo.y,oo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ui(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ws);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ci.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,ci.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,ci.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(ci.min),this.boundingBox.expandByPoint(ci.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(t){let n=this.boundingSphere.center;if(ci.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];na.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(ci.min,na.min),ci.expandByPoint(Cn),Cn.addVectors(ci.max,na.max),ci.expandByPoint(Cn)):(ci.expandByPoint(na.min),ci.expandByPoint(na.max))}ci.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,f=a.count;c<f;c++)Cn.fromBufferAttribute(a,c),l&&(oo.fromBufferAttribute(t,c),Cn.add(oo)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Kn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let B=0;B<n.count;B++)a[B]=new K,l[B]=new K;let f=new K,h=new K,u=new K,p=new Yt,m=new Yt,x=new Yt,g=new K,d=new K;function y(B,v,M){c[B]=c[v]=c[M]=1,f.fromBufferAttribute(n,B),h.fromBufferAttribute(n,v),u.fromBufferAttribute(n,M),p.fromBufferAttribute(r,B),m.fromBufferAttribute(r,v),x.fromBufferAttribute(r,M),h.sub(f),u.sub(f),m.sub(p),x.sub(p);let L=1/(m.x*x.y-x.x*m.y);isFinite(L)&&(g.copy(h).multiplyScalar(x.y).addScaledVector(u,-m.y).multiplyScalar(L),d.copy(u).multiplyScalar(m.x).addScaledVector(h,-x.x).multiplyScalar(L),a[B].add(g),a[v].add(g),a[M].add(g),l[B].add(d),l[v].add(d),l[M].add(d))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let B=0,v=b.length;B<v;++B){let M=b[B],L=M.start,I=M.count;for(let D=L,F=L+I;D<F;D+=3)y(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let S=new K,E=new K,A=new K,_=new K;function T(B){A.fromBufferAttribute(s,B),_.copy(A);let v=a[B];S.copy(v),S.sub(A.multiplyScalar(A.dot(v))).normalize(),E.crossVectors(_,v);let L=E.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,L)}for(let B=0,v=n.count;B<v;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Kn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,f=new K,h=new K;if(t)for(let u=0,p=t.count;u<p;u+=3){let m=t.getX(u+0),x=t.getX(u+1),g=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),f.subVectors(o,r),h.subVectors(s,r),f.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),a.add(f),l.add(f),c.add(f),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let u=0,p=e.count;u<p;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),f.subVectors(o,r),h.subVectors(s,r),f.cross(h),n.setXYZ(u+0,f.x,f.y,f.z),n.setXYZ(u+1,f.x,f.y,f.z),n.setXYZ(u+2,f.x,f.y,f.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,f=a.itemSize,h=a.normalized,u=new c.constructor(l.length*f),p=0,m=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*f;for(let d=0;d<f;d++)u[m++]=c[p++]}return new Kn(u,f,h)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let f=0,h=c.length;f<h;f++){let u=c[f],p=t(u,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],f=[];for(let h=0,u=c.length;h<u;h++){let p=c[h];f.push(p.toJSON(t.data))}f.length>0&&(s[l]=f,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let f=s[c];this.setAttribute(c,f.clone(e))}let r=t.morphAttributes;for(let c in r){let f=[],h=r[c];for(let u=0,p=h.length;u<p;u++)f.push(h[u].clone(e));this.morphAttributes[c]=f}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,f=o.length;c<f;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},cc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Cf,this.updateRanges=[],this.version=0,this.uuid=Qs()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Ym(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Ym(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Ym(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Qs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Xn=new K,va=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?_h(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Xn.fromBufferAttribute(this,e),Xn.applyMatrix4(t),this.setXYZ(e,Xn.x,Xn.y,Xn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Xn.fromBufferAttribute(this,e),Xn.applyNormalMatrix(t),this.setXYZ(e,Xn.x,Xn.y,Xn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Xn.fromBufferAttribute(this,e),Xn.transformDirection(t),this.setXYZ(e,Xn.x,Xn.y,Xn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){pa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Kn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){pa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Df(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Nf(t,this.data.array)}},Xu=new K,uv=new K,fv=new re,On=class{constructor(t=new K(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Xu.subVectors(n,e).cross(uv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Xu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||fv.getNormalMatrix(t),s=this.coplanarPoint(Xu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},dv=0,Ki=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dv++}),this.uuid=Qs(),this.name="",this.type="Material",this.blending=Ao,this.side=Js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cf,this.blendDst=hf,this.blendEquation=Mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=go,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ug,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=jl,this.stencilZFail=jl,this.stencilZPass=jl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new On().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Yt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},So=class extends Ki{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new he(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ao,ia=new K,lo=new K,co=new K,ho=new Yt,sa=new Yt,qg=new Be,Pl=new K,ra=new K,Il=new K,$m=new Yt,qu=new Yt,jm=new Yt,Ma=class extends Dn{constructor(t=new So){if(super(),this.isSprite=!0,this.type="Sprite",ao===void 0){ao=new pi;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new cc(e,5);ao.setIndex([0,1,2,0,2,3]),ao.setAttribute("position",new va(n,3,0,!1)),ao.setAttribute("uv",new va(n,2,3,!1))}this.geometry=ao,this.material=t,this.center=new Yt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ne('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),lo.setFromMatrixScale(this.matrixWorld),qg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),co.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&lo.multiplyScalar(-co.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Ll(Pl.set(-.5,-.5,0),co,o,lo,s,r),Ll(ra.set(.5,-.5,0),co,o,lo,s,r),Ll(Il.set(.5,.5,0),co,o,lo,s,r),$m.set(0,0),qu.set(1,0),jm.set(1,1);let a=t.ray.intersectTriangle(Pl,ra,Il,!1,ia);if(a===null&&(Ll(ra.set(-.5,.5,0),co,o,lo,s,r),qu.set(0,1),a=t.ray.intersectTriangle(Pl,Il,ra,!1,ia),a===null))return;let l=t.ray.origin.distanceTo(ia);l<t.near||l>t.far||e.push({distance:l,point:ia.clone(),uv:ys.getInterpolation(ia,Pl,ra,Il,$m,qu,jm,new Yt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Ll(i,t,e,n,s,r){ho.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(sa.x=r*ho.x-s*ho.y,sa.y=s*ho.x+r*ho.y):sa.copy(ho),i.copy(t),i.x+=sa.x,i.y+=sa.y,i.applyMatrix4(qg)}var xs=new K,Yu=new K,Dl=new K,Nl=new K,yr=class{constructor(t=new K,e=new K(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,xs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=xs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(xs.copy(this.origin).addScaledVector(this.direction,e),xs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Yu.copy(t).add(e).multiplyScalar(.5),Dl.copy(e).sub(t).normalize(),Nl.copy(this.origin).sub(Yu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Dl),a=Nl.dot(this.direction),l=-Nl.dot(Dl),c=Nl.lengthSq(),f=Math.abs(1-o*o),h,u,p,m;if(f>0)if(h=o*l-a,u=o*a-l,m=r*f,h>=0)if(u>=-m)if(u<=m){let x=1/f;h*=x,u*=x,p=h*(h+o*u+2*a)+u*(o*h+u+2*l)+c}else u=r,h=Math.max(0,-(o*u+a)),p=-h*h+u*(u+2*l)+c;else u=-r,h=Math.max(0,-(o*u+a)),p=-h*h+u*(u+2*l)+c;else u<=-m?(h=Math.max(0,-(-o*r+a)),u=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+u*(u+2*l)+c):u<=m?(h=0,u=Math.min(Math.max(-r,-l),r),p=u*(u+2*l)+c):(h=Math.max(0,-(o*r+a)),u=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+u*(u+2*l)+c);else u=o>0?-r:r,h=Math.max(0,-(o*u+a)),p=-h*h+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Yu).addScaledVector(Dl,u),p}intersectSphere(t,e){if(t.radius<0)return null;xs.subVectors(t.center,this.origin);let n=xs.dot(this.direction),s=xs.dot(xs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,f=1/this.direction.y,h=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),f>=0?(r=(t.min.y-u.y)*f,o=(t.max.y-u.y)*f):(r=(t.max.y-u.y)*f,o=(t.min.y-u.y)*f),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-u.z)*h,l=(t.max.z-u.z)*h):(a=(t.max.z-u.z)*h,l=(t.min.z-u.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,xs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,f=a.z,h=t.x-o.x,u=t.y-o.y,p=t.z-o.z,m=e.x-o.x,x=e.y-o.y,g=e.z-o.z,d=n.x-o.x,y=n.y-o.y,b=n.z-o.z,S=Math.abs(l),E=Math.abs(c),A=Math.abs(f),_,T,B,v,M,L,I,D,F,G,k,tt;if(S>=E&&S>=A?(B=l,L=h,F=m,tt=d,l>=0?(_=c,T=f,v=u,M=p,I=x,D=g,G=y,k=b):(_=f,T=c,v=p,M=u,I=g,D=x,G=b,k=y)):E>=A?(B=c,L=u,F=x,tt=y,c>=0?(_=f,T=l,v=p,M=h,I=g,D=m,G=b,k=d):(_=l,T=f,v=h,M=p,I=m,D=g,G=d,k=b)):(B=f,L=p,F=g,tt=b,f>=0?(_=l,T=c,v=h,M=u,I=m,D=x,G=d,k=y):(_=c,T=l,v=u,M=h,I=x,D=m,G=y,k=d)),B===0)return null;let V=_/B,O=T/B,H=1/B,Z=v-V*L,$=M-O*L,Y=I-V*F,it=D-O*F,st=G-V*tt,ot=k-O*tt,ut=st*it-ot*Y,Nt=Z*ot-$*st,Ht=Y*$-it*Z;if(s){if(ut<0||Nt<0||Ht<0)return null}else if((ut<0||Nt<0||Ht<0)&&(ut>0||Nt>0||Ht>0))return null;let It=ut+Nt+Ht;if(It===0)return null;let Zt=H*(ut*L+Nt*F+Ht*tt);return(It>0?Zt<0:Zt>0)?null:this.at(Zt/It,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hc=class extends Ki{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Pc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Zm=new Be,mr=new yr,Ul=new xr,Jm=new K,Fl=new K,Ol=new K,Bl=new K,$u=new K,kl=new K,Km=new K,zl=new K,Si=class extends Dn{constructor(t=new pi,e=new hc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){kl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let f=a[l],h=r[l];f!==0&&($u.fromBufferAttribute(h,t),o?kl.addScaledVector($u,f):kl.addScaledVector($u.sub(e),f))}e.add(kl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ul.copy(n.boundingSphere),Ul.applyMatrix4(r),mr.copy(t.ray).recast(t.near),!(Ul.containsPoint(mr.origin)===!1&&(mr.intersectSphere(Ul,Jm)===null||mr.origin.distanceToSquared(Jm)>(t.far-t.near)**2))&&(Zm.copy(r).invert(),mr.copy(t.ray).applyMatrix4(Zm),!(n.boundingBox!==null&&mr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,mr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,f=r.attributes.uv1,h=r.attributes.normal,u=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=u.length;m<x;m++){let g=u[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),b=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,E=b;S<E;S+=3){let A=a.getX(S),_=a.getX(S+1),T=a.getX(S+2);s=Vl(this,d,t,n,c,f,h,A,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let g=m,d=x;g<d;g+=3){let y=a.getX(g),b=a.getX(g+1),S=a.getX(g+2);s=Vl(this,o,t,n,c,f,h,y,b,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=u.length;m<x;m++){let g=u[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),b=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,E=b;S<E;S+=3){let A=S,_=S+1,T=S+2;s=Vl(this,d,t,n,c,f,h,A,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let g=m,d=x;g<d;g+=3){let y=g,b=g+1,S=g+2;s=Vl(this,o,t,n,c,f,h,y,b,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function pv(i,t,e,n,s,r,o,a){let l;if(t.side===jn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Js,a),l===null)return null;zl.copy(a),zl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(zl);return c<e.near||c>e.far?null:{distance:c,point:zl.clone(),object:i}}function Vl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Fl),i.getVertexPosition(l,Ol),i.getVertexPosition(c,Bl);let f=pv(i,t,e,n,Fl,Ol,Bl,Km);if(f){let h=new K;ys.getBarycoord(Km,Fl,Ol,Bl,h),s&&(f.uv=ys.getInterpolatedAttribute(s,a,l,c,h,new Yt)),r&&(f.uv1=ys.getInterpolatedAttribute(r,a,l,c,h,new Yt)),o&&(f.normal=ys.getInterpolatedAttribute(o,a,l,c,h,new K),f.normal.dot(n.direction)>0&&f.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new K,materialIndex:0};ys.getNormal(Fl,Ol,Bl,u.normal),f.face=u,f.barycoord=h}return f}var uc=class extends $n{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Pn,f=Pn,h,u){super(null,o,a,l,c,f,s,r,h,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var gr=new xr,mv=new Yt(.5,.5),Gl=new K,Xs=class{constructor(t=new On,e=new On,n=new On,s=new On,r=new On,o=new On){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Mi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],f=r[4],h=r[5],u=r[6],p=r[7],m=r[8],x=r[9],g=r[10],d=r[11],y=r[12],b=r[13],S=r[14],E=r[15];if(s[0].setComponents(c-o,p-f,d-m,E-y).normalize(),s[1].setComponents(c+o,p+f,d+m,E+y).normalize(),s[2].setComponents(c+a,p+h,d+x,E+b).normalize(),s[3].setComponents(c-a,p-h,d-x,E-b).normalize(),n)s[4].setComponents(l,u,g,S).normalize(),s[5].setComponents(c-l,p-u,d-g,E-S).normalize();else if(s[4].setComponents(c-l,p-u,d-g,E-S).normalize(),e===Mi)s[5].setComponents(c+l,p+u,d+g,E+S).normalize();else if(e===_o)s[5].setComponents(l,u,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),gr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),gr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(gr)}intersectsSprite(t){gr.center.set(0,0,0);let e=mv.distanceTo(t.center);return gr.radius=.7071067811865476+e,gr.applyMatrix4(t.matrixWorld),this.intersectsSphere(gr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Gl.x=s.normal.x>0?t.max.x:t.min.x,Gl.y=s.normal.y>0?t.max.y:t.min.y,Gl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Gl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qm=new Be,fc=class i{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Qm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Xs),n[s].setFromProjectionMatrix(Qm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Xs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Qi=class extends Ki{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},dc=new K,pc=new K,tg=new Be,oa=new yr,Hl=new xr,ju=new K,eg=new K,Sa=class extends Dn{constructor(t=new pi,e=new Qi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)dc.fromBufferAttribute(e,s-1),pc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=dc.distanceTo(pc);t.setAttribute("lineDistance",new ui(n,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(s),Hl.radius+=r,t.ray.intersectsSphere(Hl)===!1)return;tg.copy(s).invert(),oa.copy(t.ray).applyMatrix4(tg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,f=n.index,u=n.attributes.position;if(f!==null){let p=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let x=p,g=m-1;x<g;x+=c){let d=f.getX(x),y=f.getX(x+1),b=Wl(this,t,oa,l,d,y,x);b&&e.push(b)}if(this.isLineLoop){let x=f.getX(m-1),g=f.getX(p),d=Wl(this,t,oa,l,x,g,m-1);d&&e.push(d)}}else{let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=p,g=m-1;x<g;x+=c){let d=Wl(this,t,oa,l,x,x+1,x);d&&e.push(d)}if(this.isLineLoop){let x=Wl(this,t,oa,l,m-1,p,m-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Wl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(dc.fromBufferAttribute(a,s),pc.fromBufferAttribute(a,r),e.distanceSqToSegment(dc,pc,ju,eg)>n)return;ju.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ju);if(!(c<t.near||c>t.far))return{distance:c,point:eg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var wa=class extends $n{constructor(t=[],e=Sr,n,s,r,o,a,l,c,f){super(t,e,n,s,r,o,a,l,c,f),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ba=class extends $n{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ws=class extends $n{constructor(t,e,n=Fi,s,r,o,a=Pn,l=Pn,c,f=Ms,h=1){if(f!==Ms&&f!==Es)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:h};super(u,s,r,o,a,l,f,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new vo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ea=class extends ws{constructor(t,e=Fi,n=Sr,s,r,o=Pn,a=Pn,l,c=Ms){let f={width:t,height:t,depth:1},h=[f,f,f,f,f,f];super(t,t,e,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ta=class extends $n{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},wo=class i extends pi{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],f=[],h=[],u=0,p=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ui(c,3)),this.setAttribute("normal",new ui(f,3)),this.setAttribute("uv",new ui(h,2));function m(x,g,d,y,b,S,E,A,_,T,B){let v=S/_,M=E/T,L=S/2,I=E/2,D=A/2,F=_+1,G=T+1,k=0,tt=0,V=new K;for(let O=0;O<G;O++){let H=O*M-I;for(let Z=0;Z<F;Z++){let $=Z*v-L;V[x]=$*y,V[g]=H*b,V[d]=D,c.push(V.x,V.y,V.z),V[x]=0,V[g]=0,V[d]=A>0?1:-1,f.push(V.x,V.y,V.z),h.push(Z/_),h.push(1-O/T),k+=1}}for(let O=0;O<T;O++)for(let H=0;H<_;H++){let Z=u+H+F*O,$=u+H+F*(O+1),Y=u+(H+1)+F*(O+1),it=u+(H+1)+F*O;l.push(Z,$,it),l.push($,Y,it),tt+=6}a.addGroup(p,tt,B),p+=tt,u+=k}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Aa=class i extends pi{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,f=l+1,h=t/a,u=e/l,p=[],m=[],x=[],g=[];for(let d=0;d<f;d++){let y=d*u-o;for(let b=0;b<c;b++){let S=b*h-r;m.push(S,-y,0),x.push(0,0,1),g.push(b/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let y=0;y<a;y++){let b=y+c*d,S=y+c*(d+1),E=y+1+c*(d+1),A=y+1+c*d;p.push(b,S,A),p.push(S,E,A)}this.setIndex(p),this.setAttribute("position",new ui(m,3)),this.setAttribute("normal",new ui(x,3)),this.setAttribute("uv",new ui(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};function br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(ng(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(ng(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Bn(i){let t={};for(let e=0;e<i.length;e++){let n=br(i[e]);for(let s in n)t[s]=n[s]}return t}function ng(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function gv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Ff(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var Yg={clone:br,merge:Bn},_v=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,xv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends Ki{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_v,this.fragmentShader=xv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=gv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new K().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ke().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Be().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},mc=class extends ts{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ra=class extends Ki{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gh,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Pc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},gc=class extends Ki{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Dg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},_c=class extends Ki{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function uo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Xl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var qs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];t:{e:{let o;n:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break e}o=e.length;break n}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},xc=class extends qs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ku,endingEnd:Ku}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Qu:r=t,a=2*e-n;break;case tf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Qu:o=t,l=2*n-e;break;case tf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,f=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*f,this._offsetNext=o*f}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this._offsetPrev,h=this._offsetNext,u=this._weightPrev,p=this._weightNext,m=(n-e)/(s-e),x=m*m,g=x*m,d=-u*g+2*u*x-u*m,y=(1+u)*g+(-1.5-2*u)*x+(-.5+u)*m+1,b=(-1-p)*g+(1.5+p)*x+.5*m,S=p*g-p*x;for(let E=0;E!==a;++E)r[E]=d*o[f+E]+y*o[c+E]+b*o[l+E]+S*o[h+E];return r}},yc=class extends qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=(n-e)/(s-e),h=1-f;for(let u=0;u!==a;++u)r[u]=o[c+u]*h+o[l+u]*f;return r}},vc=class extends qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Mc=class extends qs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this.inTangents,h=this.outTangents;if(!f||!h){let m=(n-e)/(s-e),x=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*m;return r}let u=a*2,p=t-1;for(let m=0;m!==a;++m){let x=o[c+m],g=o[l+m],d=p*u+m*2,y=h[d],b=h[d+1],S=t*u+m*2,E=f[S],A=f[S+1],_=vv(n,e,y,E,s);r[m]=$g(_,x,b,A,g)}return r}};function $g(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function yv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function vv(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=$g(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=yv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=uo(e,this.TimeBufferType),this.values=uo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:uo(t.times,Array),values:uo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Xl(t.settings)&&(n.settings={inTangents:uo(t.settings.inTangents,Array),outTangents:uo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new vc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new yc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Mc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ha:e=this.InterpolantFactoryMethodDiscrete;break;case rc:e=this.InterpolantFactoryMethodLinear;break;case $l:e=this.InterpolantFactoryMethodSmooth;break;case Ju:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Kt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ha;case this.InterpolantFactoryMethodLinear:return rc;case this.InterpolantFactoryMethodSmooth:return $l;case this.InterpolantFactoryMethodBezier:return Ju}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Xl(this.settings)&&(ig(this.settings.inTangents,t),ig(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Xl(this.settings)&&(sg(this.settings.inTangents,t),sg(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ne("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ne("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ne("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ne("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Fy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ne("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===$l,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],f=t[a+1];if(c!==f&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*n,u=h-n,p=h+n;for(let m=0;m!==n;++m){let x=e[h+m];if(x!==e[u+m]||x!==e[p+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,u=o*n;for(let p=0;p!==n;++p)e[u+p]=e[h+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Xl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function ig(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function sg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}mi.prototype.ValueTypeName="";mi.prototype.TimeBufferType=Float32Array;mi.prototype.ValueBufferType=Float32Array;mi.prototype.DefaultInterpolation=rc;var Ys=class extends mi{constructor(t,e,n){super(t,e,n)}};Ys.prototype.ValueTypeName="bool";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=ha;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var Sc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};Sc.prototype.ValueTypeName="color";var wc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};wc.prototype.ValueTypeName="number";var bc=class extends qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let f=c+a;c!==f;c+=4)fi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ca=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new bc(this.times,this.values,this.getValueSize(),t)}};Ca.prototype.ValueTypeName="quaternion";Ca.prototype.InterpolantFactoryMethodSmooth=void 0;var $s=class extends mi{constructor(t,e,n){super(t,e,n)}};$s.prototype.ValueTypeName="string";$s.prototype.ValueBufferType=Array;$s.prototype.DefaultInterpolation=ha;$s.prototype.InterpolantFactoryMethodLinear=void 0;$s.prototype.InterpolantFactoryMethodSmooth=void 0;var Ec=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};Ec.prototype.ValueTypeName="vector";var Tc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(f){a++,r===!1&&s.onStart!==void 0&&s.onStart(f,o,a),r=!0},this.itemEnd=function(f){o++,s.onProgress!==void 0&&s.onProgress(f,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(f){s.onError!==void 0&&s.onError(f)},this.resolveURL=function(f){return f=f.normalize("NFC"),l?l(f):f},this.setURLModifier=function(f){return l=f,this},this.addHandler=function(f,h){return c.push(f,h),this},this.removeHandler=function(f){let h=c.indexOf(f);return h!==-1&&c.splice(h,2),this},this.getHandler=function(f){for(let h=0,u=c.length;h<u;h+=2){let p=c[h],m=c[h+1];if(p.global&&(p.lastIndex=0),p.test(f))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},jg=new Tc,Ac=class{constructor(t){this.manager=t!==void 0?t:jg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ac.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pa=class extends Dn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Zu=new Be,rg=new K,og=new K,Rc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=Qn,this.map=null,this.mapPass=null,this.matrix=new Be,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Xs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new Ke(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;rg.setFromMatrixPosition(t.matrixWorld),e.position.copy(rg),og.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(og),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Zu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Zu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===_o||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Zu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},ql=new K,Yl=new fi,Zi=new K,Ia=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Be,this.projectionMatrix=new Be,this.projectionMatrixInverse=new Be,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ql,Yl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ql,Yl,Zi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(ql,Yl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ql,Yl,Zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Hs=new K,ag=new Yt,lg=new Yt,qn=class extends Ia{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=yo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(la*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return yo*2*Math.atan(Math.tan(la*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Hs.x,Hs.y).multiplyScalar(-t/Hs.z),Hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Hs.x,Hs.y).multiplyScalar(-t/Hs.z)}getViewSize(t,e){return this.getViewBounds(t,ag,lg),e.subVectors(lg,ag)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(la*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var La=class extends Ia{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,f=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=f*this.view.offsetY,l=a-f*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},ef=class extends Rc{constructor(){super(new La(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Da=class extends Pa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new ef}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Na=class extends Pa{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var fo=-90,po=1,bo=class extends Dn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new qn(fo,po,t,e);s.layers=this.layers,this.add(s);let r=new qn(fo,po,t,e);r.layers=this.layers,this.add(r);let o=new qn(fo,po,t,e);o.layers=this.layers,this.add(o);let a=new qn(fo,po,t,e);a.layers=this.layers,this.add(a);let l=new qn(fo,po,t,e);l.layers=this.layers,this.add(l);let c=new qn(fo,po,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===_o)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,f]=this.children,h=t.getRenderTarget(),u=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,f),t.setRenderTarget(h,u,p),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Cc=class extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Of="\\[\\]\\.:\\/",Mv=new RegExp("["+Of+"]","g"),Bf="[^"+Of+"]",Sv="[^"+Of.replace("\\.","")+"]",wv=/((?:WC+[\/:])*)/.source.replace("WC",Bf),bv=/(WCOD+)?/.source.replace("WCOD",Sv),Ev=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bf),Tv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bf),Av=new RegExp("^"+wv+bv+Ev+Tv+"$"),Rv=["material","materials","bones","map"],nf=class{constructor(t,e,n){let s=n||qe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},qe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Mv,"")}static parseTrackName(t){let e=Av.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Rv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let f=0;f<t.length;f++)if(t[f].name===c){c=f;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ne("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qe.Composite=nf;qe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qe.prototype.GetterByBindingType=[qe.prototype._getValue_direct,qe.prototype._getValue_array,qe.prototype._getValue_arrayElement,qe.prototype._getValue_toArray];qe.prototype.SetterByBindingTypeAndVersioning=[[qe.prototype._setValue_direct,qe.prototype._setValue_direct_setNeedsUpdate,qe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_array,qe.prototype._setValue_array_setNeedsUpdate,qe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_arrayElement,qe.prototype._setValue_arrayElement_setNeedsUpdate,qe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_fromArray,qe.prototype._setValue_fromArray_setNeedsUpdate,qe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var vT=new Float32Array(1);var Eo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=me(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(me(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var sf=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Ua=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function kf(i,t,e,n){let s=Cv(n);switch(e){case wf:return i*t;case Ef:return i*t/s.components*s.byteLength;case Oc:return i*t/s.components*s.byteLength;case Ks:return i*t*2/s.components*s.byteLength;case Bc:return i*t*2/s.components*s.byteLength;case bf:return i*t*3/s.components*s.byteLength;case ki:return i*t*4/s.components*s.byteLength;case kc:return i*t*4/s.components*s.byteLength;case Ba:case ka:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case za:case Va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Vc:case Hc:return Math.max(i,16)*Math.max(t,8)/4;case zc:case Gc:return Math.max(i,8)*Math.max(t,8)/2;case Wc:case Xc:case Yc:case $c:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case qc:case Ga:case jc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Zc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Jc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Kc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case th:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case eh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case nh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case ih:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case sh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case rh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case oh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case lh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case ch:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case hh:case uh:case fh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case dh:case ph:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ha:case mh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Cv(i){switch(i){case Qn:case yf:return{byteLength:1,components:1};case Co:case vf:case Bi:return{byteLength:2,components:1};case Uc:case Fc:return{byteLength:2,components:4};case Fi:case Nc:case Oi:return{byteLength:4,components:1};case Mf:case Sf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function _0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Iv(i){let t=new WeakMap;function e(a,l){let c=a.array,f=a.usage,h=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,f),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let f=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,f);else{h.sort((p,m)=>p.start-m.start);let u=0;for(let p=1;p<h.length;p++){let m=h[u],x=h[p];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++u,h[u]=x)}h.length=u+1;for(let p=0,m=h.length;p<m;p++){let x=h[p];i.bufferSubData(c,x.start*f.BYTES_PER_ELEMENT,f,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let f=t.get(a);(!f||f.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Lv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Dv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Nv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Uv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Fv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ov=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Bv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,kv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,zv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Vv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Hv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Wv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Xv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,qv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Yv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,$v=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Zv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Jv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Qv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,tM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,eM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,nM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,iM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,oM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,aM="gl_FragColor = linearToOutputTexel( gl_FragColor );",lM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,hM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,uM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,fM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,dM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,pM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_M=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,xM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,yM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,MM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,SM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,wM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,bM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,EM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,TM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,AM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,RM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,CM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,PM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,IM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,LM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,DM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,NM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,UM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,FM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,OM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,BM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,kM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,VM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,GM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,HM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,WM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,XM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,qM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,YM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,$M=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ZM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,JM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,KM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,QM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,tS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,eS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,nS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,iS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,rS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,oS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,aS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,lS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,hS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,uS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,fS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,dS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,pS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,mS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,gS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,_S=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,xS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,yS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,MS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,wS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,bS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ES=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,TS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,AS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,RS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,CS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,PS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,IS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,LS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,US=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,FS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,OS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,BS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,kS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,zS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,VS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,WS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,XS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,qS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$S=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,ZS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,JS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,KS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,QS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ew=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,nw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,ow=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,aw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,hw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ue={alphahash_fragment:Lv,alphahash_pars_fragment:Dv,alphamap_fragment:Nv,alphamap_pars_fragment:Uv,alphatest_fragment:Fv,alphatest_pars_fragment:Ov,aomap_fragment:Bv,aomap_pars_fragment:kv,batching_pars_vertex:zv,batching_vertex:Vv,begin_vertex:Gv,beginnormal_vertex:Hv,bsdfs:Wv,iridescence_fragment:Xv,bumpmap_pars_fragment:qv,clipping_planes_fragment:Yv,clipping_planes_pars_fragment:$v,clipping_planes_pars_vertex:jv,clipping_planes_vertex:Zv,color_fragment:Jv,color_pars_fragment:Kv,color_pars_vertex:Qv,color_vertex:tM,common:eM,defaultnormal_vertex:nM,displacementmap_pars_vertex:iM,displacementmap_vertex:sM,emissivemap_fragment:rM,emissivemap_pars_fragment:oM,colorspace_fragment:aM,colorspace_pars_fragment:lM,envmap_fragment:cM,envmap_common_pars_fragment:hM,envmap_pars_fragment:uM,envmap_pars_vertex:fM,envmap_physical_pars_fragment:wM,envmap_vertex:dM,fog_vertex:pM,fog_pars_vertex:mM,fog_fragment:gM,fog_pars_fragment:_M,gradientmap_pars_fragment:xM,lightmap_pars_fragment:yM,lights_lambert_fragment:vM,lights_lambert_pars_fragment:MM,lights_pars_begin:SM,lights_toon_fragment:bM,lights_toon_pars_fragment:EM,lights_phong_fragment:TM,lights_phong_pars_fragment:AM,lights_physical_fragment:RM,lights_physical_pars_fragment:CM,lights_fragment_begin:PM,lights_fragment_maps:IM,lights_fragment_end:LM,lightprobes_pars_fragment:DM,logdepthbuf_fragment:NM,logdepthbuf_pars_fragment:UM,logdepthbuf_pars_vertex:FM,logdepthbuf_vertex:OM,map_fragment:BM,map_pars_fragment:kM,map_particle_fragment:zM,map_particle_pars_fragment:VM,metalnessmap_fragment:GM,metalnessmap_pars_fragment:HM,morphinstance_vertex:WM,morphcolor_vertex:XM,morphnormal_vertex:qM,morphtarget_pars_vertex:YM,morphtarget_vertex:$M,normal_fragment_begin:jM,normal_fragment_maps:ZM,normal_pars_fragment:JM,normal_pars_vertex:KM,normal_vertex:QM,normalmap_pars_fragment:tS,clearcoat_normal_fragment_begin:eS,clearcoat_normal_fragment_maps:nS,clearcoat_pars_fragment:iS,iridescence_pars_fragment:sS,opaque_fragment:rS,packing:oS,premultiplied_alpha_fragment:aS,project_vertex:lS,dithering_fragment:cS,dithering_pars_fragment:hS,roughnessmap_fragment:uS,roughnessmap_pars_fragment:fS,shadowmap_pars_fragment:dS,shadowmap_pars_vertex:pS,shadowmap_vertex:mS,shadowmask_pars_fragment:gS,skinbase_vertex:_S,skinning_pars_vertex:xS,skinning_vertex:yS,skinnormal_vertex:vS,specularmap_fragment:MS,specularmap_pars_fragment:SS,tonemapping_fragment:wS,tonemapping_pars_fragment:bS,transmission_fragment:ES,transmission_pars_fragment:TS,uv_pars_fragment:AS,uv_pars_vertex:RS,uv_vertex:CS,worldpos_vertex:PS,background_vert:IS,background_frag:LS,backgroundCube_vert:DS,backgroundCube_frag:NS,cube_vert:US,cube_frag:FS,depth_vert:OS,depth_frag:BS,distance_vert:kS,distance_frag:zS,equirect_vert:VS,equirect_frag:GS,linedashed_vert:HS,linedashed_frag:WS,meshbasic_vert:XS,meshbasic_frag:qS,meshlambert_vert:YS,meshlambert_frag:$S,meshmatcap_vert:jS,meshmatcap_frag:ZS,meshnormal_vert:JS,meshnormal_frag:KS,meshphong_vert:QS,meshphong_frag:tw,meshphysical_vert:ew,meshphysical_frag:nw,meshtoon_vert:iw,meshtoon_frag:sw,points_vert:rw,points_frag:ow,shadow_vert:aw,shadow_frag:lw,sprite_vert:cw,sprite_frag:hw},Dt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},is={basic:{uniforms:Bn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:Bn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Bn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Bn([Dt.common,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.roughnessmap,Dt.metalnessmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Bn([Dt.common,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.gradientmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Bn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Bn([Dt.points,Dt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Bn([Dt.common,Dt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Bn([Dt.common,Dt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Bn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Bn([Dt.sprite,Dt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:Bn([Dt.common,Dt.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:Bn([Dt.lights,Dt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};is.physical={uniforms:Bn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var xh={r:0,b:0,g:0},uw=new Be,x0=new re;x0.set(-1,0,0,0,1,0,0,0,1);function fw(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,l,c,f=null,h=0,u=null;function p(y){let b=y.isScene===!0?y.background:null;if(b&&b.isTexture){let S=y.backgroundBlurriness>0;b=t.get(b,S)}return b}function m(y){let b=!1,S=p(y);S===null?g(o,a):S&&S.isColor&&(g(S,1),b=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,b){let S=p(b);S&&S.isCubeTexture?(c===void 0&&(c=new Si(new wo(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:br(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uw.makeRotationFromEuler(b.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(x0),c.material.toneMapped=ve.getTransfer(S.colorSpace)!==Pe,(f!==S||h!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,f=S,h=S.version,u=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Si(new Aa(2,2),new ts({name:"BackgroundMaterial",uniforms:br(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:Js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=ve.getTransfer(S.colorSpace)!==Pe,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(f!==S||h!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,f=S,h=S.version,u=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,b){y.getRGB(xh,Ff(i)),e.buffers.color.setClear(xh.r,xh.g,xh.b,b,r)}function d(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,b=1){o.set(y),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:x,dispose:d}}function dw(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(M,L,I,D,F){let G=!1,k=h(M,D,I,L);r!==k&&(r=k,c(r.object)),G=p(M,D,I,F),G&&m(M,D,I,F),F!==null&&t.update(F,i.ELEMENT_ARRAY_BUFFER),(G||o)&&(o=!1,S(M,L,I,D),F!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(F).buffer))}function l(){return i.createVertexArray()}function c(M){return i.bindVertexArray(M)}function f(M){return i.deleteVertexArray(M)}function h(M,L,I,D){let F=D.wireframe===!0,G=n[L.id];G===void 0&&(G={},n[L.id]=G);let k=M.isInstancedMesh===!0?M.id:0,tt=G[k];tt===void 0&&(tt={},G[k]=tt);let V=tt[I.id];V===void 0&&(V={},tt[I.id]=V);let O=V[F];return O===void 0&&(O=u(l()),V[F]=O),O}function u(M){let L=[],I=[],D=[];for(let F=0;F<e;F++)L[F]=0,I[F]=0,D[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:L,enabledAttributes:I,attributeDivisors:D,object:M,attributes:{},index:null}}function p(M,L,I,D){let F=r.attributes,G=L.attributes,k=0,tt=I.getAttributes();for(let V in tt)if(tt[V].location>=0){let H=F[V],Z=G[V];if(Z===void 0&&(V==="instanceMatrix"&&M.instanceMatrix&&(Z=M.instanceMatrix),V==="instanceColor"&&M.instanceColor&&(Z=M.instanceColor)),H===void 0||H.attribute!==Z||Z&&H.data!==Z.data)return!0;k++}return r.attributesNum!==k||r.index!==D}function m(M,L,I,D){let F={},G=L.attributes,k=0,tt=I.getAttributes();for(let V in tt)if(tt[V].location>=0){let H=G[V];H===void 0&&(V==="instanceMatrix"&&M.instanceMatrix&&(H=M.instanceMatrix),V==="instanceColor"&&M.instanceColor&&(H=M.instanceColor));let Z={};Z.attribute=H,H&&H.data&&(Z.data=H.data),F[V]=Z,k++}r.attributes=F,r.attributesNum=k,r.index=D}function x(){let M=r.newAttributes;for(let L=0,I=M.length;L<I;L++)M[L]=0}function g(M){d(M,0)}function d(M,L){let I=r.newAttributes,D=r.enabledAttributes,F=r.attributeDivisors;I[M]=1,D[M]===0&&(i.enableVertexAttribArray(M),D[M]=1),F[M]!==L&&(i.vertexAttribDivisor(M,L),F[M]=L)}function y(){let M=r.newAttributes,L=r.enabledAttributes;for(let I=0,D=L.length;I<D;I++)L[I]!==M[I]&&(i.disableVertexAttribArray(I),L[I]=0)}function b(M,L,I,D,F,G,k){k===!0?i.vertexAttribIPointer(M,L,I,F,G):i.vertexAttribPointer(M,L,I,D,F,G)}function S(M,L,I,D){x();let F=D.attributes,G=I.getAttributes(),k=L.defaultAttributeValues;for(let tt in G){let V=G[tt];if(V.location>=0){let O=F[tt];if(O===void 0&&(tt==="instanceMatrix"&&M.instanceMatrix&&(O=M.instanceMatrix),tt==="instanceColor"&&M.instanceColor&&(O=M.instanceColor)),O!==void 0){let H=O.normalized,Z=O.itemSize,$=t.get(O);if($===void 0)continue;let Y=$.buffer,it=$.type,st=$.bytesPerElement,ot=it===i.INT||it===i.UNSIGNED_INT||O.gpuType===Nc;if(O.isInterleavedBufferAttribute){let ut=O.data,Nt=ut.isInterleavedBuffer===!0?ut.stride:ut.itemSize,Ht=O.offset;if(ut.isInstancedInterleavedBuffer||ut.isInstancedBufferAttribute){for(let It=0;It<V.locationSize;It++)d(V.location+It,ut.meshPerAttribute);M.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ut.meshPerAttribute*ut.count)}else for(let It=0;It<V.locationSize;It++)g(V.location+It);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let It=0;It<V.locationSize;It++)b(V.location+It,Z/V.locationSize,it,H,Nt*st,(Ht+Z/V.locationSize*It)*st,ot)}else{if(O.isInstancedBufferAttribute){for(let ut=0;ut<V.locationSize;ut++)d(V.location+ut,O.meshPerAttribute);M.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=O.meshPerAttribute*O.count)}else for(let ut=0;ut<V.locationSize;ut++)g(V.location+ut);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let ut=0;ut<V.locationSize;ut++)b(V.location+ut,Z/V.locationSize,it,H,Z*st,Z/V.locationSize*ut*st,ot)}}else if(k!==void 0){let H=k[tt];if(H!==void 0)switch(H.length){case 2:i.vertexAttrib2fv(V.location,H);break;case 3:i.vertexAttrib3fv(V.location,H);break;case 4:i.vertexAttrib4fv(V.location,H);break;default:i.vertexAttrib1fv(V.location,H)}}}}y()}function E(){B();for(let M in n){let L=n[M];for(let I in L){let D=L[I];for(let F in D){let G=D[F];for(let k in G)f(G[k].object),delete G[k];delete D[F]}}delete n[M]}}function A(M){if(n[M.id]===void 0)return;let L=n[M.id];for(let I in L){let D=L[I];for(let F in D){let G=D[F];for(let k in G)f(G[k].object),delete G[k];delete D[F]}}delete n[M.id]}function _(M){for(let L in n){let I=n[L];for(let D in I){let F=I[D];if(F[M.id]===void 0)continue;let G=F[M.id];for(let k in G)f(G[k].object),delete G[k];delete F[M.id]}}}function T(M){for(let L in n){let I=n[L],D=M.isInstancedMesh===!0?M.id:0,F=I[D];if(F!==void 0){for(let G in F){let k=F[G];for(let tt in k)f(k[tt].object),delete k[tt];delete F[G]}delete I[D],Object.keys(I).length===0&&delete n[L]}}}function B(){v(),o=!0,r!==s&&(r=s,c(r.object))}function v(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:v,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:g,disableUnusedAttributes:y}}function pw(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,f){f!==0&&(i.drawArraysInstanced(n,l,c,f),e.update(c,n,f))}function a(l,c,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,f);let u=0;for(let p=0;p<f;p++)u+=c[p];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function mw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ki&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Bi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==Qn&&_!==Oi&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",f=l(c);f!==c&&(Kt("WebGLRenderer:",c,"not supported, using",f,"instead."),c=f);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:y,maxVaryings:b,maxFragmentUniforms:S,maxSamples:E,samples:A}}function gw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new On,a=new re,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,u){let p=h.length!==0||u||n!==0||s;return s=u,n=h.length,p},this.beginShadows=function(){r=!0,f(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,u){e=f(h,u,0)},this.setState=function(h,u,p){let m=h.clippingPlanes,x=h.clipIntersection,g=h.clipShadows,d=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?f(null):c();else{let y=r?0:n,b=y*4,S=d.clippingState||null;l.value=S,S=f(m,u,b,p);for(let E=0;E!==b;++E)S[E]=e[E];d.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function f(h,u,p,m){let x=h!==null?h.length:0,g=null;if(x!==0){if(g=l.value,m!==!0||g===null){let d=p+x*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<d)&&(g=new Float32Array(d));for(let b=0,S=p;b!==x;++b,S+=4)o.copy(h[b]).applyMatrix4(y,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var qa=class extends di{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new wa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new wo(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:jn,blending:vr});r.uniforms.tEquirect.value=e;let o=new Si(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=Yn),new bo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Zg=256,_w=3,xw=20,y0=256,v0=16,yw=3,vw=new K,Mw=new he,vh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new bo(1,10,null),this._boxMesh=new Si(new wo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=vw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),f=this._getSourceTarget(!0);e>0&&(f.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(Mw));let g=new bo(n,s,f);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=m,t.background=x,e>0&&(f.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Qg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Kg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Zg,Lf(t))}_fromTexture(t,e){t.mapping===Sr||t.mapping===Ro?this._setSize(t.image.length===0?Zg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Jg(t,!1,!1),n=Math.log2(t)-_w;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Jg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Sr||t.mapping===Ro?(this._cubemapMaterial===null&&(this._cubemapMaterial=Qg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Kg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Sw(),this._integrationMaterial=ww());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/v0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-yw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(y0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=bw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Jg(i,t,e){return new qa(i,{minFilter:bs,generateMipmaps:t,type:Bi,colorSpace:ua,depthBuffer:e})}function Ya(i,t,e){return new ts({name:i,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:jn,blending:vr,depthTest:!1,depthWrite:!1})}function Sw(){return Ya("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${y0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ww(){return Ya("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:v0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function bw(){return Ya("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${xw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Kg(){return Ya("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Qg(){return Ya("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Ew(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,p=!1){return u==null?null:p?o(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===Ic||p===Lc)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let x=new qa(m.height);return x.fromEquirectangularTexture(i,u),t.set(u,x),u.addEventListener("dispose",c),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,m=p===Ic||p===Lc,x=p===Sr||p===Ro;if(m||x){let g=e.get(u),d=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==d)return n===null&&(n=new vh(i)),g=m?n.fromEquirectangular(u,g):n.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),g.texture;if(g!==void 0)return g.texture;{let y=u.image;return m&&y&&y.height>0||x&&y&&l(y)?(n===null&&(n=new vh(i)),g=m?n.fromEquirectangular(u):n.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),u.addEventListener("dispose",f),g.texture):null}}}return u}function a(u,p){return p===Ic?u.mapping=Sr:p===Lc&&(u.mapping=Ro),u}function l(u){let p=0,m=6;for(let x=0;x<m;x++)u[x]!==void 0&&p++;return p===m}function c(u){let p=u.target;p.removeEventListener("dispose",c);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function f(u){let p=u.target;p.removeEventListener("dispose",f);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function Tw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&aa("WebGLRenderer: "+n+" extension not supported."),s}}}function Aw(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let x=r.get(m);x&&(t.remove(x),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function f(m){let x=m.attributes;for(let g in x)t.update(x[g],i.ARRAY_BUFFER)}function h(m){let x=m.index,g=m.attributes.position,d=0;if(g===void 0)return;let y=x!==null?x.array.length:g.array.length/3-1,b=g.count>=65535?ya:xa,S=new b(Math.ceil(y/3)*6,1),E=S.array;if(x!==null){let _=x.array;d=x.version;for(let T=0,B=0;T<y;T+=3){let v=_[T+0],M=_[T+1],L=_[T+2];E[B++]=v,E[B++]=M,E[B++]=M,E[B++]=L,E[B++]=L,E[B++]=v}}else{d=g.version;for(let _=0,T=0;_<y;_+=3){let B=_+0,v=_+1,M=_+2;E[T++]=B,E[T++]=v,E[T++]=v,E[T++]=M,E[T++]=M,E[T++]=B}}S.version=d;let A=r.get(m);A&&t.remove(A),r.set(m,S)}function u(m){let x=r.get(m);if(x){let g=m.index;g!==null&&x.version<g.version&&h(m)}else h(m);return r.get(m)}function p(){for(let m in s){let x=s[m].deref();x!==void 0&&l(x)}}return{get:c,update:f,getWireframeAttribute:u,dispose:p}}function Rw(i,t,e){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,u){i.drawElements(n,u,r,h*o),e.update(u,n,1)}function c(h,u,p){p!==0&&(i.drawElementsInstanced(n,u,r,h*o,p),e.update(u,n,p))}function f(h,u,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,h,0,p);let x=0;for(let g=0;g<p;g++)x+=u[g];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=f}function Cw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ne("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Pw(i,t,e){let n=new WeakMap,s=new Ke;function r(o,a,l){let c=o.morphTargetInfluences,f=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=f!==void 0?f.length:0,u=n.get(a);if(u===void 0||u.count!==h){let B=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",B)};u!==void 0&&u.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],b=0;p===!0&&(b=1),m===!0&&(b=2),x===!0&&(b=3);let S=a.attributes.position.count*b,E=1;S>t.maxTextureSize&&(E=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let A=new Float32Array(S*E*4*h),_=new ma(A,S,E,h);_.type=Oi,_.needsUpdate=!0;let T=b*4;for(let v=0;v<h;v++){let M=g[v],L=d[v],I=y[v],D=S*E*4*v;for(let F=0;F<M.count;F++){let G=F*T;p===!0&&(s.fromBufferAttribute(M,F),A[D+G+0]=s.x,A[D+G+1]=s.y,A[D+G+2]=s.z,A[D+G+3]=0),m===!0&&(s.fromBufferAttribute(L,F),A[D+G+4]=s.x,A[D+G+5]=s.y,A[D+G+6]=s.z,A[D+G+7]=0),x===!0&&(s.fromBufferAttribute(I,F),A[D+G+8]=s.x,A[D+G+9]=s.y,A[D+G+10]=s.z,A[D+G+11]=I.itemSize===4?s.w:1)}}u={count:h,texture:_,size:new Yt(S,E)},n.set(a,u),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Iw(i,t,e,n,s){let r=new WeakMap;function o(c){let f=s.render.frame,h=c.geometry,u=t.get(c,h);if(r.get(u)!==f&&(t.update(u),r.set(u,f)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==f&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,f))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==f&&(p.update(),r.set(p,f))}return u}function a(){r=new WeakMap}function l(c){let f=c.target;f.removeEventListener("dispose",l),n.releaseStatesOfObject(f),e.remove(f.instanceMatrix),f.instanceColor!==null&&e.remove(f.instanceColor)}return{update:o,dispose:a}}var Lw={[uf]:"LINEAR_TONE_MAPPING",[ff]:"REINHARD_TONE_MAPPING",[df]:"CINEON_TONE_MAPPING",[pf]:"ACES_FILMIC_TONE_MAPPING",[gf]:"AGX_TONE_MAPPING",[_f]:"NEUTRAL_TONE_MAPPING",[mf]:"CUSTOM_TONE_MAPPING"};function Dw(i,t,e,n,s,r){let o=new di(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,f=new pi;f.setAttribute("position",new ui([-1,3,0,-1,-1,0,3,-1,0],3)),f.setAttribute("uv",new ui([0,2,0,0,2,0],2));let h=new mc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Si(f,h),p=new La(-1,1,1,-1,0,1),m=null,x=null,g=!1,d,y=null,b=[],S=!1;this.setSize=function(E,A){o.setSize(E,A),a!==null&&a.setSize(E,A),l!==null&&l.setSize(E,A);for(let _=0;_<b.length;_++){let T=b[_];T.setSize&&T.setSize(E,A)}},this.setEffects=function(E){b=E,S=b.length>0&&b[0].isRenderPass===!0;let A=o.width,_=o.height;b.length>0&&a===null&&(a=new di(A,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),l=new di(A,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&b.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new ws(A,_),r===!0&&(c.format=Es,c.type=wr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<b.length;B++){let v=b[B];v.setSize&&v.setSize(A,_),T&&v.needsDepthTexture===!0&&v.setDepthTexture&&v.setDepthTexture(c)}},this.begin=function(E,A){if(g||E.toneMapping===es&&b.length===0)return!1;if(y=A,A!==null){let _=A.width,T=A.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return S===!1&&E.setRenderTarget(o),d=E.toneMapping,E.toneMapping=es,!0},this.hasRenderPass=function(){return S},this.end=function(E,A){E.toneMapping=d,g=!0;let _=o,T=a;for(let B=0;B<b.length;B++){let v=b[B];v.enabled!==!1&&(v.render(E,T,_,A),v.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(m!==E.outputColorSpace||x!==E.toneMapping){m=E.outputColorSpace,x=E.toneMapping,h.defines={},ve.getTransfer(m)===Pe&&(h.defines.SRGB_TRANSFER="");let B=Lw[x];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,E.setRenderTarget(y),E.render(u,p),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),f.dispose(),h.dispose()}}var M0=new $n,S0=new ws(1,1),w0=new Ea(1),b0=new ma,E0=new lc,T0=new wa,t0=[],e0=[],n0=new Float32Array(16),i0=new Float32Array(9),s0=new Float32Array(4);function Io(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=t0[s];if(r===void 0&&(r=new Float32Array(s),t0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Sn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function wn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Sh(i,t){let e=e0[t];e===void 0&&(e=new Int32Array(t),e0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Nw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Uw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2fv(this.addr,t),wn(e,t)}}function Fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Sn(e,t))return;i.uniform3fv(this.addr,t),wn(e,t)}}function Ow(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4fv(this.addr,t),wn(e,t)}}function Bw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),wn(e,t)}else{if(Sn(e,n))return;s0.set(n),i.uniformMatrix2fv(this.addr,!1,s0),wn(e,n)}}function kw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),wn(e,t)}else{if(Sn(e,n))return;i0.set(n),i.uniformMatrix3fv(this.addr,!1,i0),wn(e,n)}}function zw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),wn(e,t)}else{if(Sn(e,n))return;n0.set(n),i.uniformMatrix4fv(this.addr,!1,n0),wn(e,n)}}function Vw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Gw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2iv(this.addr,t),wn(e,t)}}function Hw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Sn(e,t))return;i.uniform3iv(this.addr,t),wn(e,t)}}function Ww(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4iv(this.addr,t),wn(e,t)}}function Xw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function qw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2uiv(this.addr,t),wn(e,t)}}function Yw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Sn(e,t))return;i.uniform3uiv(this.addr,t),wn(e,t)}}function $w(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4uiv(this.addr,t),wn(e,t)}}function wh(i){return i.version===0&&(i.compareFunction=Rf,i.needsUpdate=!0),i}function jw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=wh(S0):r=M0,e.setTexture2D(t||r,s)}function Zw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||E0,s)}function Jw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=wh(w0):r=T0,e.setTextureCube(t||r,s)}function Kw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||b0,s)}function Qw(i){switch(i){case 5126:return Nw;case 35664:return Uw;case 35665:return Fw;case 35666:return Ow;case 35674:return Bw;case 35675:return kw;case 35676:return zw;case 5124:case 35670:return Vw;case 35667:case 35671:return Gw;case 35668:case 35672:return Hw;case 35669:case 35673:return Ww;case 5125:return Xw;case 36294:return qw;case 36295:return Yw;case 36296:return $w;case 35678:case 36198:case 36298:case 36306:case 35682:return jw;case 35679:case 36299:case 36307:return Zw;case 35680:case 36300:case 36308:case 36293:return Jw;case 36289:case 36303:case 36311:case 36292:return Kw}}function tb(i,t){i.uniform1fv(this.addr,t)}function eb(i,t){let e=Io(t,this.size,2);i.uniform2fv(this.addr,e)}function nb(i,t){let e=Io(t,this.size,3);i.uniform3fv(this.addr,e)}function ib(i,t){let e=Io(t,this.size,4);i.uniform4fv(this.addr,e)}function sb(i,t){let e=Io(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function rb(i,t){let e=Io(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function ob(i,t){let e=Io(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function ab(i,t){i.uniform1iv(this.addr,t)}function lb(i,t){i.uniform2iv(this.addr,t)}function cb(i,t){i.uniform3iv(this.addr,t)}function hb(i,t){i.uniform4iv(this.addr,t)}function ub(i,t){i.uniform1uiv(this.addr,t)}function fb(i,t){i.uniform2uiv(this.addr,t)}function db(i,t){i.uniform3uiv(this.addr,t)}function pb(i,t){i.uniform4uiv(this.addr,t)}function mb(i,t,e){let n=this.cache,s=t.length,r=Sh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=wh(S0):o=M0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function gb(i,t,e){let n=this.cache,s=t.length,r=Sh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||E0,r[o])}function _b(i,t,e){let n=this.cache,s=t.length,r=Sh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=wh(w0):o=T0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function xb(i,t,e){let n=this.cache,s=t.length,r=Sh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||b0,r[o])}function yb(i){switch(i){case 5126:return tb;case 35664:return eb;case 35665:return nb;case 35666:return ib;case 35674:return sb;case 35675:return rb;case 35676:return ob;case 5124:case 35670:return ab;case 35667:case 35671:return lb;case 35668:case 35672:return cb;case 35669:case 35673:return hb;case 5125:return ub;case 36294:return fb;case 36295:return db;case 36296:return pb;case 35678:case 36198:case 36298:case 36306:case 35682:return mb;case 35679:case 36299:case 36307:return gb;case 35680:case 36300:case 36308:case 36293:return _b;case 36289:case 36303:case 36311:case 36292:return xb}}var Gf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Qw(e.type)}},Hf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=yb(e.type)}},Wf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},zf=/(\w+)(\])?(\[|\.)?/g;function r0(i,t){i.seq.push(t),i.map[t.id]=t}function vb(i,t,e){let n=i.name,s=n.length;for(zf.lastIndex=0;;){let r=zf.exec(n),o=zf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){r0(e,c===void 0?new Gf(a,i,t):new Hf(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new Wf(a),r0(e,h)),e=h}}}var Po=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);vb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function o0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Mb=37297,Sb=0;function wb(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var a0=new re;function bb(i){ve._getMatrix(a0,ve.workingColorSpace,i);let t=`mat3( ${a0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case fa:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function l0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+wb(i.getShaderSource(t),a)}else return r}function Eb(i,t){let e=bb(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Tb={[uf]:"Linear",[ff]:"Reinhard",[df]:"Cineon",[pf]:"ACESFilmic",[gf]:"AgX",[_f]:"Neutral",[mf]:"Custom"};function Ab(i,t){let e=Tb[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var yh=new K;function Rb(){ve.getLuminanceCoefficients(yh);let i=yh.x.toFixed(4),t=yh.y.toFixed(4),e=yh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Cb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Xa).join(`
`)}function Pb(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Ib(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Xa(i){return i!==""}function c0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function h0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Lb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xf(i){return i.replace(Lb,Db)}function Db(i,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Xf(e)}var Nb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function u0(i){return i.replace(Nb,Ub)}function Ub(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function f0(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Fb={[Fa]:"SHADOWMAP_TYPE_PCF",[To]:"SHADOWMAP_TYPE_VSM"};function Ob(i){return Fb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Bb={[Ro]:"ENVMAP_MODE_REFRACTION"};function kb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Bb[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var zb={[Pc]:"ENVMAP_BLENDING_MULTIPLY",[Pg]:"ENVMAP_BLENDING_MIX",[Ig]:"ENVMAP_BLENDING_ADD"};function Vb(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":zb[i.combine]||"ENVMAP_BLENDING_NONE"}function Gb(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Ob(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",f=kb(e),h=Vb(e),u=Cb(e),p=Pb(r),m=s.createProgram(),x,g,d=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Xa).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Xa).join(`
`),g.length>0&&(g+=`
`)):(x=[f0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+f:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Xa).join(`
`),g=[f0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+f:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==es?"#define TONE_MAPPING":"",e.toneMapping!==es?ue.tonemapping_pars_fragment:"",e.toneMapping!==es?Ab("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,Eb("linearToOutputTexel",e.outputColorSpace),Rb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Xa).join(`
`)),o=Xf(o),o=c0(o,e),o=h0(o,e),a=Xf(a),a=c0(a,e),a=h0(a,e),o=u0(o),a=u0(a),e.isRawShaderMaterial!==!0&&(d=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=d+x+o,b=d+g+a,S=o0(s,s.VERTEX_SHADER,y),E=o0(s,s.FRAGMENT_SHADER,b);s.attachShader(m,S),s.attachShader(m,E),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(v){if(i.debug.checkShaderErrors){let M=s.getProgramInfoLog(m)||"",L=s.getShaderInfoLog(S)||"",I=s.getShaderInfoLog(E)||"",D=M.trim(),F=L.trim(),G=I.trim(),k=!0,tt=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,S,E);else{let V=l0(s,S,"vertex"),O=l0(s,E,"fragment");ne("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+v.name+`
Material Type: `+v.type+`

Program Info Log: `+D+`
`+V+`
`+O)}else D!==""?Kt("WebGLProgram: Program Info Log:",D):(F===""||G==="")&&(tt=!1);tt&&(v.diagnostics={runnable:k,programLog:D,vertexShader:{log:F,prefix:x},fragmentShader:{log:G,prefix:g}})}s.deleteShader(S),s.deleteShader(E),_=new Po(s,m),T=Ib(s,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let B=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(m,Mb)),B},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Sb++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=E,this}var Hb=0,qf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Yf(t),e.set(t,n)),n}},Yf=class{constructor(t){this.id=Hb++,this.code=t,this.usedTimes=0}};function Wb(i){return i===Ks||i===Ga||i===Ha}function Xb(i,t,e,n,s,r){let o=new ga,a=new qf,l=new Set,c=[],f=new Map,h=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,T,B,v,M,L){let I=v.fog,D=M.geometry,F=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?v.environment:null,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,k=t.get(_.envMap||F,G),tt=u[_.type],V=n.precision;_.precision!==null&&(V=n.getMaxPrecision(_.precision),V!==_.precision&&Kt("WebGLProgram.getParameters:",_.precision,"not supported, using",V,"instead."));let O=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,H=O!==void 0?O.length:0,Z=0;D.morphAttributes.position!==void 0&&(Z=1),D.morphAttributes.normal!==void 0&&(Z=2),D.morphAttributes.color!==void 0&&(Z=3);let $,Y,it,st;if(tt){let Ct=is[tt];$=Ct.vertexShader,Y=Ct.fragmentShader}else{$=_.vertexShader,Y=_.fragmentShader;let Ct=a.getVertexShaderStage(_),ae=a.getFragmentShaderStage(_);a.update(_,Ct,ae),it=Ct.id,st=ae.id}let ot=i.getRenderTarget(),ut=i.state.buffers.depth.getReversed(),Nt=M.isInstancedMesh===!0,Ht=M.isBatchedMesh===!0,It=!!_.map,Zt=!!_.matcap,$t=!!k,Jt=$t&&k.isPMREMTexture===!0,Re=!!_.aoMap,Me=!!_.lightMap,$e=!!_.bumpMap&&_.wireframe===!1,Se=!!_.normalMap,tn=!!_.displacementMap,fe=!!_.emissiveMap,hn=!!_.metalnessMap,je=!!_.roughnessMap,en=_.anisotropy>0,W=_.clearcoat>0,Rt=_.diffuseRoughness>0,jt=_.dispersion>0,se=_.retroreflectivity>0,wt=_.iridescence>0,Ie=_.sheen>0,Vt=_.transmission>0,qt=en&&!!_.anisotropyMap,N=W&&!!_.clearcoatMap,R=W&&!!_.clearcoatNormalMap,J=W&&!!_.clearcoatRoughnessMap,mt=Rt&&!!_.diffuseRoughnessMap,ft=wt&&!!_.iridescenceMap,yt=wt&&!!_.iridescenceThicknessMap,vt=Ie&&!!_.sheenColorMap,at=Ie&&!!_.sheenRoughnessMap,ct=!!_.specularMap,_t=!!_.specularColorMap,X=!!_.specularIntensityMap,ht=Vt&&!!_.transmissionMap,lt=Vt&&!!_.thicknessMap,Et=!!_.gradientMap,xt=!!_.alphaMap,bt=_.alphaTest>0,Wt=!!_.alphaHash,te=!!_.extensions,pt=es;_.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(pt=i.toneMapping);let kt=Jt?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,ee={shaderID:tt,shaderType:_.type,shaderName:_.name,vertexShader:$,fragmentShader:Y,defines:_.defines,customVertexShaderID:it,customFragmentShaderID:st,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:V,batching:Ht,batchingColor:Ht&&M._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&M.instanceColor!==null,instancingMorph:Nt&&M.morphTexture!==null,outputColorSpace:ot===null?i.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:It,matcap:Zt,envMap:$t,envMapMode:$t&&k.mapping,envMapPMREM:Jt,envMapMaxLod:Jt?kt.length-1:null,envMapSize:Jt?kt[0].width:null,aoMap:Re,lightMap:Me,bumpMap:$e,normalMap:Se,displacementMap:tn,emissiveMap:fe,normalMapObjectSpace:Se&&_.normalMapType===Ng,normalMapTangentSpace:Se&&_.normalMapType===gh,packedNormalMap:Se&&_.normalMapType===gh&&Wb(_.normalMap.format),metalnessMap:hn,roughnessMap:je,anisotropy:en,anisotropyMap:qt,clearcoat:W,clearcoatMap:N,clearcoatNormalMap:R,clearcoatRoughnessMap:J,diffuseRoughness:Rt,diffuseRoughnessMap:mt,dispersion:jt,retroreflection:se,iridescence:wt,iridescenceMap:ft,iridescenceThicknessMap:yt,sheen:Ie,sheenColorMap:vt,sheenRoughnessMap:at,specularMap:ct,specularColorMap:_t,specularIntensityMap:X,transmission:Vt,transmissionMap:ht,thicknessMap:lt,gradientMap:Et,opaque:_.transparent===!1&&_.blending===Ao&&_.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Wt,combine:_.combine,mapUv:It&&p(_.map.channel),aoMapUv:Re&&p(_.aoMap.channel),lightMapUv:Me&&p(_.lightMap.channel),bumpMapUv:$e&&p(_.bumpMap.channel),normalMapUv:Se&&p(_.normalMap.channel),displacementMapUv:tn&&p(_.displacementMap.channel),emissiveMapUv:fe&&p(_.emissiveMap.channel),metalnessMapUv:hn&&p(_.metalnessMap.channel),roughnessMapUv:je&&p(_.roughnessMap.channel),anisotropyMapUv:qt&&p(_.anisotropyMap.channel),clearcoatMapUv:N&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:R&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:ft&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:at&&p(_.sheenRoughnessMap.channel),specularMapUv:ct&&p(_.specularMap.channel),specularColorMapUv:_t&&p(_.specularColorMap.channel),specularIntensityMapUv:X&&p(_.specularIntensityMap.channel),transmissionMapUv:ht&&p(_.transmissionMap.channel),thicknessMapUv:lt&&p(_.thicknessMap.channel),alphaMapUv:xt&&p(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Se||en),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:M.isPoints===!0&&!!D.attributes.uv&&(It||xt),fog:!!I,useFog:_.fog===!0,fogExp2:!!I&&I.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Se===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ut,skinning:M.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:H,morphTextureStride:Z,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:L.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&B.length>0,shadowMapType:i.shadowMap.type,toneMapping:pt,decodeVideoTexture:It&&_.map.isVideoTexture===!0&&ve.getTransfer(_.map.colorSpace)===Pe,decodeVideoTextureEmissive:fe&&_.emissiveMap.isVideoTexture===!0&&ve.getTransfer(_.emissiveMap.colorSpace)===Pe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===wi,flipSided:_.side===jn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||Ht)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ee.vertexUv1s=l.has(1),ee.vertexUv2s=l.has(2),ee.vertexUv3s=l.has(3),l.clear(),ee}function x(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let B in _.defines)T.push(B),T.push(_.defines[B]);return _.isRawShaderMaterial===!1&&(g(T,_),d(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function g(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function d(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let T=u[_.type],B;if(T){let v=is[T];B=Yg.clone(v.uniforms)}else B=_.uniforms;return B}function b(_,T){let B=f.get(T);return B!==void 0?++B.usedTimes:(B=new Gb(i,T,_,s),c.push(B),f.set(T,B)),B}function S(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),f.delete(_.cacheKey),_.destroy()}}function E(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:y,acquireProgram:b,releaseProgram:S,releaseShaderCache:E,programs:c,dispose:A}}function qb(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Yb(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function d0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function p0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function a(u,p,m,x,g,d){let y=i[t];return y===void 0?(y={id:u.id,object:u,geometry:p,material:m,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:g,group:d},i[t]=y):(y.id=u.id,y.object=u,y.geometry=p,y.material=m,y.materialVariant=o(u),y.groupOrder=x,y.renderOrder=u.renderOrder,y.z=g,y.group=d),t++,y}function l(u,p,m,x,g,d,y){y.reversedDepth===!0&&(g=-g);let b=a(u,p,m,x,g,d);m.transmission>0?n.push(b):m.transparent===!0?s.push(b):e.push(b)}function c(u,p,m,x,g,d){let y=a(u,p,m,x,g,d);m.transmission>0?n.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function f(u,p){e.length>1&&e.sort(u||Yb),n.length>1&&n.sort(p||d0),s.length>1&&s.sort(p||d0)}function h(){for(let u=t,p=i.length;u<p;u++){let m=i[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:f}}function $b(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new p0,i.set(n,[o])):s>=r.length?(o=new p0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function jb(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new K,color:new he};break;case"SpotLight":e={position:new K,direction:new K,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new K,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new K,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new K,halfWidth:new K,halfHeight:new K};break}return i[t.id]=e,e}}}function Zb(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Jb=0;function Kb(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Qb(i){let t=new jb,e=Zb(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new K);let s=new K,r=new Be,o=new Be;function a(c){let f=0,h=0,u=0;for(let L=0;L<9;L++)n.probe[L].set(0,0,0);let p=0,m=0,x=0,g=0,d=0,y=0,b=0,S=0,E=0,A=0,_=0,T=0,B=0,v=0;c.sort(Kb);for(let L=0,I=c.length;L<I;L++){let D=c[L],F=D.color,G=D.intensity,k=D.distance,tt=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ks?tt=D.shadow.map.texture:tt=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)f+=F.r*G,h+=F.g*G,u+=F.b*G;else if(D.isLightProbe){for(let V=0;V<9;V++)n.probe[V].addScaledVector(D.sh.coefficients[V],G);v++}else if(D.isSunLight){let V=t.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let O=D.shadow,H=e.get(D);H.shadowIntensity=O.intensity,H.shadowBias=O.bias,H.shadowNormalBias=O.normalBias,H.shadowRadius=O.radius,H.shadowMapSize.copy(O.mapSize).multiply(O.getFrameExtents()),n.sunShadow[m]=H,n.sunShadowMap[m]=tt;let Z=O.getViewportCount();for(let $=0;$<Z;$++)n.sunShadowMatrix[x+$]=O.getMatrix($),n.sunShadowCascade[x+$]=O._cascadeData[$];x+=Z,m++}n.sun[p]=V,p++}else if(D.isDirectionalLight){let V=t.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let O=D.shadow,H=e.get(D);H.shadowIntensity=O.intensity,H.shadowBias=O.bias,H.shadowNormalBias=O.normalBias,H.shadowRadius=O.radius,H.shadowMapSize=O.mapSize,n.directionalShadow[g]=H,n.directionalShadowMap[g]=tt,n.directionalShadowMatrix[g]=D.shadow.matrix,E++}n.directional[g]=V,g++}else if(D.isSpotLight){let V=t.get(D);V.position.setFromMatrixPosition(D.matrixWorld),V.color.copy(F).multiplyScalar(G),V.distance=k,V.coneCos=Math.cos(D.angle),V.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),V.decay=D.decay,n.spot[y]=V;let O=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,O.updateMatrices(D),D.castShadow&&B++),n.spotLightMatrix[y]=O.matrix,D.castShadow){let H=e.get(D);H.shadowIntensity=O.intensity,H.shadowBias=O.bias,H.shadowNormalBias=O.normalBias,H.shadowRadius=O.radius,H.shadowMapSize=O.mapSize,n.spotShadow[y]=H,n.spotShadowMap[y]=tt,_++}y++}else if(D.isRectAreaLight){let V=t.get(D);V.color.copy(F).multiplyScalar(G),V.halfWidth.set(D.width*.5,0,0),V.halfHeight.set(0,D.height*.5,0),n.rectArea[b]=V,b++}else if(D.isPointLight){let V=t.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),V.distance=D.distance,V.decay=D.decay,D.castShadow){let O=D.shadow,H=e.get(D);H.shadowIntensity=O.intensity,H.shadowBias=O.bias,H.shadowNormalBias=O.normalBias,H.shadowRadius=O.radius,H.shadowMapSize=O.mapSize,H.shadowCameraNear=O.camera.near,H.shadowCameraFar=O.camera.far,n.pointShadow[d]=H,n.pointShadowMap[d]=tt,n.pointShadowMatrix[d]=D.shadow.matrix,A++}n.point[d]=V,d++}else if(D.isHemisphereLight){let V=t.get(D);V.skyColor.copy(D.color).multiplyScalar(G),V.groundColor.copy(D.groundColor).multiplyScalar(G),n.hemi[S]=V,S++}}b>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Dt.LTC_FLOAT_1,n.rectAreaLTC2=Dt.LTC_FLOAT_2):(n.rectAreaLTC1=Dt.LTC_HALF_1,n.rectAreaLTC2=Dt.LTC_HALF_2)),n.ambient[0]=f,n.ambient[1]=h,n.ambient[2]=u;let M=n.hash;(M.sunLength!==p||M.directionalLength!==g||M.pointLength!==d||M.spotLength!==y||M.rectAreaLength!==b||M.hemiLength!==S||M.numSunShadows!==m||M.numDirectionalShadows!==E||M.numPointShadows!==A||M.numSpotShadows!==_||M.numSpotMaps!==T||M.numLightProbes!==v)&&(n.sun.length=p,n.directional.length=g,n.spot.length=y,n.rectArea.length=b,n.point.length=d,n.hemi.length=S,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-B,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=B,n.numLightProbes=v,M.sunLength=p,M.directionalLength=g,M.pointLength=d,M.spotLength=y,M.rectAreaLength=b,M.hemiLength=S,M.numSunShadows=m,M.numDirectionalShadows=E,M.numPointShadows=A,M.numSpotShadows=_,M.numSpotMaps=T,M.numLightProbes=v,n.version=Jb++)}function l(c,f){let h=0,u=0,p=0,m=0,x=0,g=0,d=f.matrixWorldInverse;for(let y=0,b=c.length;y<b;y++){let S=c[y];if(S.isSunLight){let E=n.sun[h];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(d),h++}else if(S.isDirectionalLight){let E=n.directional[u];E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),u++}else if(S.isSpotLight){let E=n.spot[m];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),m++}else if(S.isRectAreaLight){let E=n.rectArea[x];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),o.identity(),r.copy(S.matrixWorld),r.premultiply(d),o.extractRotation(r),E.halfWidth.set(S.width*.5,0,0),E.halfHeight.set(0,S.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let E=n.point[p];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),p++}else if(S.isHemisphereLight){let E=n.hemi[g];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(d),g++}}}return{setup:a,setupView:l,state:n}}function m0(i){let t=new Qb(i),e=[],n=[],s=[];function r(h){f.camera=h,e.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){n.push(h)}function l(){t.setup(e),s.sort((h,u)=>h.priority-u.priority||h.id-u.id)}function c(h){t.setupView(e,h)}let f={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:f,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function t1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new m0(i),t.set(s,[a])):r>=o.length?(a=new m0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var e1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,n1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,i1=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],s1=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],g0=new Be,Wa=new K,Vf=new K;function r1(i,t,e){let n=new Xs,s=new Yt,r=new Yt,o=new Ke,a=new gc,l=new _c,c={},f=e.maxTextureSize,h={[Js]:jn,[jn]:Js,[wi]:wi},u=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:e1,fragmentShader:n1}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let m=new pi;m.setAttribute("position",new Kn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Si(m,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Fa;let d=this.type;this.render=function(A,_,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===ug&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Fa);let B=i.getRenderTarget(),v=i.getActiveCubeFace(),M=i.getActiveMipmapLevel(),L=i.state;L.setBlending(vr),L.buffers.depth.getReversed()===!0?L.buffers.color.setClear(0,0,0,0):L.buffers.color.setClear(1,1,1,1),L.buffers.depth.setTest(!0),L.setScissorTest(!1);let I=d!==this.type;I&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(F=>F.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,F=A.length;D<F;D++){let G=A[D],k=G.shadow;if(k===void 0){Kt("WebGLShadowMap:",G,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let tt=k.getFrameExtents();s.multiply(tt),r.copy(k.mapSize),(s.x>f||s.y>f)&&(s.x>f&&(r.x=Math.floor(f/tt.x),s.x=r.x*tt.x,k.mapSize.x=r.x),s.y>f&&(r.y=Math.floor(f/tt.y),s.y=r.y*tt.y,k.mapSize.y=r.y));let V=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=V,k.map===null||I===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===To){if(G.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new di(s.x,s.y,{format:Ks,type:Bi,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),k.map.texture.name=G.name+".shadowMap",k.map.depthTexture=new ws(s.x,s.y,Oi),k.map.depthTexture.name=G.name+".shadowMapDepth",k.map.depthTexture.format=Ms,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Pn,k.map.depthTexture.magFilter=Pn}else G.isPointLight?(k.map=new qa(s.x),k.map.depthTexture=new Ea(s.x,Fi)):(k.map=new di(s.x,s.y),k.map.depthTexture=new ws(s.x,s.y,Fi)),k.map.depthTexture.name=G.name+".shadowMap",k.map.depthTexture.format=Ms,this.type===Fa?(k.map.depthTexture.compareFunction=V?Af:Tf,k.map.depthTexture.minFilter=Yn,k.map.depthTexture.magFilter=Yn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Pn,k.map.depthTexture.magFilter=Pn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let O=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();G.isPointLight!==!0&&k.updateMatrices(G,T);let H=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:T.layers;for(let Z=0;Z<O;Z++){let $=k.getCamera(Z);if(G.isPointLight){let Y=k.camera,it=k.matrix,st=G.distance||Y.far;st!==Y.far&&(Y.far=st,Y.updateProjectionMatrix()),Wa.setFromMatrixPosition(G.matrixWorld),Y.position.copy(Wa),Vf.copy(Y.position),Vf.add(i1[Z]),Y.up.copy(s1[Z]),Y.lookAt(Vf),Y.updateMatrixWorld(),it.makeTranslation(-Wa.x,-Wa.y,-Wa.z),g0.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),k._frustum.setFromProjectionMatrix(g0,Y.coordinateSystem,Y.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)i.setRenderTarget(k.map,Z),i.clear();else{Z===0&&(i.setRenderTarget(k.map),i.clear());let Y=k.getViewport(Z);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),L.viewport(o)}n=k.getFrustum(Z),S(_,T,$,G,H,this.type)}k.isPointLightShadow!==!0&&this.type===To&&y(k,T),k.needsUpdate=!1}d=this.type,g.needsUpdate=!1,i.setRenderTarget(B,v,M)};function y(A,_){let T=t.update(x);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new di(s.x,s.y,{format:Ks,type:Bi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,T,u,x,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,T,p,x,null)}function b(A,_,T,B){let v=null,M=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(M!==void 0)v=M;else if(v=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let L=v.uuid,I=_.uuid,D=c[L];D===void 0&&(D={},c[L]=D);let F=D[I];F===void 0&&(F=v.clone(),D[I]=F,_.addEventListener("dispose",E)),v=F}if(v.visible=_.visible,v.wireframe=_.wireframe,B===To?v.side=_.shadowSide!==null?_.shadowSide:_.side:v.side=_.shadowSide!==null?_.shadowSide:h[_.side],v.alphaMap=_.alphaMap,v.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,v.map=_.map,v.clipShadows=_.clipShadows,v.clippingPlanes=_.clippingPlanes,v.clipIntersection=_.clipIntersection,v.displacementMap=_.displacementMap,v.displacementScale=_.displacementScale,v.displacementBias=_.displacementBias,v.wireframeLinewidth=_.wireframeLinewidth,v.linewidth=_.linewidth,T.isPointLight===!0&&v.isMeshDistanceMaterial===!0){let L=i.properties.get(v);L.light=T}return v}function S(A,_,T,B,v,M){if(A.visible===!1)return;if(A.layers.test(v)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&M===To)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let D=t.update(A),F=A.material;if(Array.isArray(F)){let G=D.groups;for(let k=0,tt=G.length;k<tt;k++){let V=G[k],O=F[V.materialIndex];if(O&&O.visible){let H=b(A,O,B,M);A.onBeforeShadow(i,A,_,T,D,H,V),i.renderBufferDirect(T,null,D,H,A,V),A.onAfterShadow(i,A,_,T,D,H,V)}}}else if(F.visible){let G=b(A,F,B,M);A.onBeforeShadow(i,A,_,T,D,G,null),i.renderBufferDirect(T,null,D,G,A,null),A.onAfterShadow(i,A,_,T,D,G,null)}}let I=A.children;for(let D=0,F=I.length;D<F;D++)S(I[D],_,T,B,v,M)}function E(A){A.target.removeEventListener("dispose",E);for(let T in c){let B=c[T],v=A.target.uuid;v in B&&(B[v].dispose(),delete B[v])}}}function o1(i,t){function e(){let X=!1,ht=new Ke,lt=null,Et=new Ke(0,0,0,0);return{setMask:function(xt){lt!==xt&&!X&&(i.colorMask(xt,xt,xt,xt),lt=xt)},setLocked:function(xt){X=xt},setClear:function(xt,bt,Wt,te,pt){pt===!0&&(xt*=te,bt*=te,Wt*=te),ht.set(xt,bt,Wt,te),Et.equals(ht)===!1&&(i.clearColor(xt,bt,Wt,te),Et.copy(ht))},reset:function(){X=!1,lt=null,Et.set(-1,0,0,0)}}}function n(){let X=!1,ht=!1,lt=null,Et=null,xt=null;return{setReversed:function(bt){if(ht!==bt){let Wt=t.get("EXT_clip_control");bt?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),ht=bt;let te=xt;xt=null,this.setClear(te)}},getReversed:function(){return ht},setTest:function(bt){bt?ut(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(bt){lt!==bt&&!X&&(i.depthMask(bt),lt=bt)},setFunc:function(bt){if(ht&&(bt=Wg[bt]),Et!==bt){switch(bt){case Zl:i.depthFunc(i.NEVER);break;case Jl:i.depthFunc(i.ALWAYS);break;case Kl:i.depthFunc(i.LESS);break;case go:i.depthFunc(i.LEQUAL);break;case Ql:i.depthFunc(i.EQUAL);break;case tc:i.depthFunc(i.GEQUAL);break;case ec:i.depthFunc(i.GREATER);break;case nc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=bt}},setLocked:function(bt){X=bt},setClear:function(bt){xt!==bt&&(xt=bt,ht&&(bt=1-bt),i.clearDepth(bt))},reset:function(){X=!1,lt=null,Et=null,xt=null,ht=!1}}}function s(){let X=!1,ht=null,lt=null,Et=null,xt=null,bt=null,Wt=null,te=null,pt=null;return{setTest:function(kt){X||(kt?ut(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(kt){ht!==kt&&!X&&(i.stencilMask(kt),ht=kt)},setFunc:function(kt,ee,Ct){(lt!==kt||Et!==ee||xt!==Ct)&&(i.stencilFunc(kt,ee,Ct),lt=kt,Et=ee,xt=Ct)},setOp:function(kt,ee,Ct){(bt!==kt||Wt!==ee||te!==Ct)&&(i.stencilOp(kt,ee,Ct),bt=kt,Wt=ee,te=Ct)},setLocked:function(kt){X=kt},setClear:function(kt){pt!==kt&&(i.clearStencil(kt),pt=kt)},reset:function(){X=!1,ht=null,lt=null,Et=null,xt=null,bt=null,Wt=null,te=null,pt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,f={},h={},u={},p=new WeakMap,m=[],x=null,g=!1,d=null,y=null,b=null,S=null,E=null,A=null,_=null,T=new he(0,0,0),B=0,v=!1,M=null,L=null,I=null,D=null,F=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,tt=0,V=i.getParameter(i.VERSION);V.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(V)[1]),k=tt>=1):V.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(V)[1]),k=tt>=2);let O=null,H={},Z=i.getParameter(i.SCISSOR_BOX),$=i.getParameter(i.VIEWPORT),Y=new Ke().fromArray(Z),it=new Ke().fromArray($);function st(X,ht,lt,Et){let xt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(X,bt),i.texParameteri(X,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(X,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Wt=0;Wt<lt;Wt++)X===i.TEXTURE_3D||X===i.TEXTURE_2D_ARRAY?i.texImage3D(ht,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,xt):i.texImage2D(ht+Wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xt);return bt}let ot={};ot[i.TEXTURE_2D]=st(i.TEXTURE_2D,i.TEXTURE_2D,1),ot[i.TEXTURE_CUBE_MAP]=st(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ot[i.TEXTURE_2D_ARRAY]=st(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ot[i.TEXTURE_3D]=st(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ut(i.DEPTH_TEST),o.setFunc(go),$e(!1),Se(rf),ut(i.CULL_FACE),Re(vr);function ut(X){f[X]!==!0&&(i.enable(X),f[X]=!0)}function Nt(X){f[X]!==!1&&(i.disable(X),f[X]=!1)}function Ht(X,ht){return u[X]!==ht?(i.bindFramebuffer(X,ht),u[X]=ht,X===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=ht),X===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=ht),!0):!1}function It(X,ht){let lt=m,Et=!1;if(X){lt=p.get(ht),lt===void 0&&(lt=[],p.set(ht,lt));let xt=X.textures;if(lt.length!==xt.length||lt[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Wt=xt.length;bt<Wt;bt++)lt[bt]=i.COLOR_ATTACHMENT0+bt;lt.length=xt.length,Et=!0}}else lt[0]!==i.BACK&&(lt[0]=i.BACK,Et=!0);Et&&i.drawBuffers(lt)}function Zt(X){return x!==X?(i.useProgram(X),x=X,!0):!1}let $t={[Mr]:i.FUNC_ADD,[dg]:i.FUNC_SUBTRACT,[pg]:i.FUNC_REVERSE_SUBTRACT};$t[mg]=i.MIN,$t[gg]=i.MAX;let Jt={[_g]:i.ZERO,[xg]:i.ONE,[yg]:i.SRC_COLOR,[cf]:i.SRC_ALPHA,[Eg]:i.SRC_ALPHA_SATURATE,[wg]:i.DST_COLOR,[Mg]:i.DST_ALPHA,[vg]:i.ONE_MINUS_SRC_COLOR,[hf]:i.ONE_MINUS_SRC_ALPHA,[bg]:i.ONE_MINUS_DST_COLOR,[Sg]:i.ONE_MINUS_DST_ALPHA,[Tg]:i.CONSTANT_COLOR,[Ag]:i.ONE_MINUS_CONSTANT_COLOR,[Rg]:i.CONSTANT_ALPHA,[Cg]:i.ONE_MINUS_CONSTANT_ALPHA};function Re(X,ht,lt,Et,xt,bt,Wt,te,pt,kt){if(X===vr){g===!0&&(Nt(i.BLEND),g=!1);return}if(g===!1&&(ut(i.BLEND),g=!0),X!==fg){if(X!==d||kt!==v){if((y!==Mr||E!==Mr)&&(i.blendEquation(i.FUNC_ADD),y=Mr,E=Mr),kt)switch(X){case Ao:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case of:i.blendFunc(i.ONE,i.ONE);break;case af:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case lf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ne("WebGLState: Invalid blending: ",X);break}else switch(X){case Ao:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case of:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case af:ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case lf:ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ne("WebGLState: Invalid blending: ",X);break}b=null,S=null,A=null,_=null,T.set(0,0,0),B=0,d=X,v=kt}return}xt=xt||ht,bt=bt||lt,Wt=Wt||Et,(ht!==y||xt!==E)&&(i.blendEquationSeparate($t[ht],$t[xt]),y=ht,E=xt),(lt!==b||Et!==S||bt!==A||Wt!==_)&&(i.blendFuncSeparate(Jt[lt],Jt[Et],Jt[bt],Jt[Wt]),b=lt,S=Et,A=bt,_=Wt),(te.equals(T)===!1||pt!==B)&&(i.blendColor(te.r,te.g,te.b,pt),T.copy(te),B=pt),d=X,v=!1}function Me(X,ht){X.side===wi?Nt(i.CULL_FACE):ut(i.CULL_FACE);let lt=X.side===jn;ht&&(lt=!lt),$e(lt),X.blending===Ao&&X.transparent===!1?Re(vr):Re(X.blending,X.blendEquation,X.blendSrc,X.blendDst,X.blendEquationAlpha,X.blendSrcAlpha,X.blendDstAlpha,X.blendColor,X.blendAlpha,X.premultipliedAlpha),o.setFunc(X.depthFunc),o.setTest(X.depthTest),o.setMask(X.depthWrite),r.setMask(X.colorWrite);let Et=X.stencilWrite;a.setTest(Et),Et&&(a.setMask(X.stencilWriteMask),a.setFunc(X.stencilFunc,X.stencilRef,X.stencilFuncMask),a.setOp(X.stencilFail,X.stencilZFail,X.stencilZPass)),fe(X.polygonOffset,X.polygonOffsetFactor,X.polygonOffsetUnits),X.alphaToCoverage===!0?ut(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function $e(X){M!==X&&(X?i.frontFace(i.CW):i.frontFace(i.CCW),M=X)}function Se(X){X!==cg?(ut(i.CULL_FACE),X!==L&&(X===rf?i.cullFace(i.BACK):X===hg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),L=X}function tn(X){X!==I&&(k&&i.lineWidth(X),I=X)}function fe(X,ht,lt){X?(ut(i.POLYGON_OFFSET_FILL),(D!==ht||F!==lt)&&(D=ht,F=lt,o.getReversed()&&(ht=-ht,lt=-lt),i.polygonOffset(ht,lt))):Nt(i.POLYGON_OFFSET_FILL)}function hn(X){X?ut(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function je(X){X===void 0&&(X=i.TEXTURE0+G-1),O!==X&&(i.activeTexture(X),O=X)}function en(X,ht,lt){lt===void 0&&(O===null?lt=i.TEXTURE0+G-1:lt=O);let Et=H[lt];Et===void 0&&(Et={type:void 0,texture:void 0},H[lt]=Et),(Et.type!==X||Et.texture!==ht)&&(O!==lt&&(i.activeTexture(lt),O=lt),i.bindTexture(X,ht||ot[X]),Et.type=X,Et.texture=ht)}function W(){let X=H[O];X!==void 0&&X.type!==void 0&&(i.bindTexture(X.type,null),X.type=void 0,X.texture=void 0)}function Rt(){try{i.compressedTexImage2D(...arguments)}catch(X){ne("WebGLState:",X)}}function jt(){try{i.compressedTexImage3D(...arguments)}catch(X){ne("WebGLState:",X)}}function se(){try{i.texSubImage2D(...arguments)}catch(X){ne("WebGLState:",X)}}function wt(){try{i.texSubImage3D(...arguments)}catch(X){ne("WebGLState:",X)}}function Ie(){try{i.compressedTexSubImage2D(...arguments)}catch(X){ne("WebGLState:",X)}}function Vt(){try{i.compressedTexSubImage3D(...arguments)}catch(X){ne("WebGLState:",X)}}function qt(){try{i.texStorage2D(...arguments)}catch(X){ne("WebGLState:",X)}}function N(){try{i.texStorage3D(...arguments)}catch(X){ne("WebGLState:",X)}}function R(){try{i.texImage2D(...arguments)}catch(X){ne("WebGLState:",X)}}function J(){try{i.texImage3D(...arguments)}catch(X){ne("WebGLState:",X)}}function mt(X){return h[X]!==void 0?h[X]:i.getParameter(X)}function ft(X,ht){h[X]!==ht&&(i.pixelStorei(X,ht),h[X]=ht)}function yt(X){Y.equals(X)===!1&&(i.scissor(X.x,X.y,X.z,X.w),Y.copy(X))}function vt(X){it.equals(X)===!1&&(i.viewport(X.x,X.y,X.z,X.w),it.copy(X))}function at(X,ht){let lt=c.get(ht);lt===void 0&&(lt=new WeakMap,c.set(ht,lt));let Et=lt.get(X);Et===void 0&&(Et=i.getUniformBlockIndex(ht,X.name),i.uniformBlockBinding(ht,Et,Et),lt.set(X,Et))}function ct(X,ht,lt){let xt=c.get(ht).get(X);l[xt]!==lt&&(i.bindBufferBase(i.UNIFORM_BUFFER,xt,lt),l[xt]=lt)}function _t(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),f={},h={},O=null,H={},u={},l={},p=new WeakMap,m=[],x=null,g=!1,d=null,y=null,b=null,S=null,E=null,A=null,_=null,T=new he(0,0,0),B=0,v=!1,M=null,L=null,I=null,D=null,F=null,Y.set(0,0,i.canvas.width,i.canvas.height),it.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ut,disable:Nt,bindFramebuffer:Ht,drawBuffers:It,useProgram:Zt,setBlending:Re,setMaterial:Me,setFlipSided:$e,setCullFace:Se,setLineWidth:tn,setPolygonOffset:fe,setScissorTest:hn,activeTexture:je,bindTexture:en,unbindTexture:W,compressedTexImage2D:Rt,compressedTexImage3D:jt,texImage2D:R,texImage3D:J,pixelStorei:ft,getParameter:mt,updateUBOMapping:at,uniformBlockBinding:ct,texStorage2D:qt,texStorage3D:N,texSubImage2D:se,texSubImage3D:wt,compressedTexSubImage2D:Ie,compressedTexSubImage3D:Vt,scissor:yt,viewport:vt,reset:_t}}function a1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,f=new WeakMap,h=new Set,u,p=new WeakMap,m=new Set,x=new FinalizationRegistry(N=>m.delete(N)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function d(N,R){return g?new OffscreenCanvas(N,R):da("canvas")}function y(N,R,J){let mt=1,ft=qt(N);if((ft.width>J||ft.height>J)&&(mt=J/Math.max(ft.width,ft.height)),mt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let yt=Math.floor(mt*ft.width),vt=Math.floor(mt*ft.height);u===void 0&&(u=d(yt,vt));let at=R?d(yt,vt):u;return at.width=yt,at.height=vt,at.getContext("2d").drawImage(N,0,0,yt,vt),Kt("WebGLRenderer: Texture has been resized from ("+ft.width+"x"+ft.height+") to ("+yt+"x"+vt+")."),at}else return"data"in N&&Kt("WebGLRenderer: Image in DataTexture is too big ("+ft.width+"x"+ft.height+")."),N;return N}function b(N){return N.generateMipmaps}function S(N){i.generateMipmap(N)}function E(N){return N.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?i.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(N,R,J,mt,ft,yt=!1){if(N!==null){if(i[N]!==void 0)return i[N];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let vt;mt&&(vt=t.get("EXT_texture_norm16"),vt||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let at=R;if(R===i.RED&&(J===i.FLOAT&&(at=i.R32F),J===i.HALF_FLOAT&&(at=i.R16F),J===i.UNSIGNED_BYTE&&(at=i.R8),J===i.UNSIGNED_SHORT&&vt&&(at=vt.R16_EXT),J===i.SHORT&&vt&&(at=vt.R16_SNORM_EXT)),R===i.RED_INTEGER&&(J===i.UNSIGNED_BYTE&&(at=i.R8UI),J===i.UNSIGNED_SHORT&&(at=i.R16UI),J===i.UNSIGNED_INT&&(at=i.R32UI),J===i.BYTE&&(at=i.R8I),J===i.SHORT&&(at=i.R16I),J===i.INT&&(at=i.R32I)),R===i.RG&&(J===i.FLOAT&&(at=i.RG32F),J===i.HALF_FLOAT&&(at=i.RG16F),J===i.UNSIGNED_BYTE&&(at=i.RG8),J===i.UNSIGNED_SHORT&&vt&&(at=vt.RG16_EXT),J===i.SHORT&&vt&&(at=vt.RG16_SNORM_EXT)),R===i.RG_INTEGER&&(J===i.UNSIGNED_BYTE&&(at=i.RG8UI),J===i.UNSIGNED_SHORT&&(at=i.RG16UI),J===i.UNSIGNED_INT&&(at=i.RG32UI),J===i.BYTE&&(at=i.RG8I),J===i.SHORT&&(at=i.RG16I),J===i.INT&&(at=i.RG32I)),R===i.RGB_INTEGER&&(J===i.UNSIGNED_BYTE&&(at=i.RGB8UI),J===i.UNSIGNED_SHORT&&(at=i.RGB16UI),J===i.UNSIGNED_INT&&(at=i.RGB32UI),J===i.BYTE&&(at=i.RGB8I),J===i.SHORT&&(at=i.RGB16I),J===i.INT&&(at=i.RGB32I)),R===i.RGBA_INTEGER&&(J===i.UNSIGNED_BYTE&&(at=i.RGBA8UI),J===i.UNSIGNED_SHORT&&(at=i.RGBA16UI),J===i.UNSIGNED_INT&&(at=i.RGBA32UI),J===i.BYTE&&(at=i.RGBA8I),J===i.SHORT&&(at=i.RGBA16I),J===i.INT&&(at=i.RGBA32I)),R===i.RGB&&(J===i.UNSIGNED_SHORT&&vt&&(at=vt.RGB16_EXT),J===i.SHORT&&vt&&(at=vt.RGB16_SNORM_EXT),J===i.UNSIGNED_INT_5_9_9_9_REV&&(at=i.RGB9_E5),J===i.UNSIGNED_INT_10F_11F_11F_REV&&(at=i.R11F_G11F_B10F)),R===i.RGBA){let ct=yt?fa:ve.getTransfer(ft);J===i.FLOAT&&(at=i.RGBA32F),J===i.HALF_FLOAT&&(at=i.RGBA16F),J===i.UNSIGNED_BYTE&&(at=ct===Pe?i.SRGB8_ALPHA8:i.RGBA8),J===i.UNSIGNED_SHORT&&vt&&(at=vt.RGBA16_EXT),J===i.SHORT&&vt&&(at=vt.RGBA16_SNORM_EXT),J===i.UNSIGNED_SHORT_4_4_4_4&&(at=i.RGBA4),J===i.UNSIGNED_SHORT_5_5_5_1&&(at=i.RGB5_A1)}return(at===i.R16F||at===i.R32F||at===i.RG16F||at===i.RG32F||at===i.RGBA16F||at===i.RGBA32F)&&t.get("EXT_color_buffer_float"),at}function _(N,R){let J;return N?R===null||R===Fi||R===wr?J=i.DEPTH24_STENCIL8:R===Oi?J=i.DEPTH32F_STENCIL8:R===Co&&(J=i.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Fi||R===wr?J=i.DEPTH_COMPONENT24:R===Oi?J=i.DEPTH_COMPONENT32F:R===Co&&(J=i.DEPTH_COMPONENT16),J}function T(N,R){return b(N)===!0||N.isFramebufferTexture&&N.minFilter!==Pn&&N.minFilter!==Yn?Math.log2(Math.max(R.width,R.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?R.mipmaps.length:1}function B(N){let R=new WeakRef(N);n.get(N).__ref=R,m.add(R),x.register(N,R,R)}function v(N){let R=n.get(N).__ref;R!==void 0&&(m.delete(R),x.unregister(R))}function M(N){I(N.target)}function L(N){D(N.target)}function I(N){N.removeEventListener("dispose",M),v(N),G(N),N.isVideoTexture&&f.delete(N),N.isHTMLTexture&&h.delete(N)}function D(N){N.removeEventListener("dispose",L),v(N),tt(N)}function F(){for(let N of m){let R=N.deref();R!==void 0&&(R.isRenderTarget===!0?D(R):I(R))}m.clear(),h.clear()}function G(N){let R=n.get(N);if(R.__webglInit===void 0)return;let J=N.source,mt=p.get(J);if(mt){let ft=mt[R.__cacheKey];ft.usedTimes--,ft.usedTimes===0&&k(N),Object.keys(mt).length===0&&p.delete(J)}n.remove(N)}function k(N){let R=n.get(N);i.deleteTexture(R.__webglTexture);let J=N.source,mt=p.get(J);delete mt[R.__cacheKey],o.memory.textures--}function tt(N){let R=n.get(N);R.__depthDisposeCallback&&R.__depthDisposeCallback();let J=N.depthTexture;if(J&&J.renderTarget===N&&I(J),N.isWebGLCubeRenderTarget)for(let ft=0;ft<6;ft++){if(Array.isArray(R.__webglFramebuffer[ft]))for(let yt=0;yt<R.__webglFramebuffer[ft].length;yt++)i.deleteFramebuffer(R.__webglFramebuffer[ft][yt]);else i.deleteFramebuffer(R.__webglFramebuffer[ft]);R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer[ft])}else{if(Array.isArray(R.__webglFramebuffer))for(let ft=0;ft<R.__webglFramebuffer.length;ft++)i.deleteFramebuffer(R.__webglFramebuffer[ft]);else i.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&i.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ft=0;ft<R.__webglColorRenderbuffer.length;ft++)R.__webglColorRenderbuffer[ft]&&i.deleteRenderbuffer(R.__webglColorRenderbuffer[ft]);R.__webglDepthRenderbuffer&&i.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=N.textures;for(let ft=0,yt=mt.length;ft<yt;ft++){let vt=n.get(mt[ft]);vt.__webglTexture&&(i.deleteTexture(vt.__webglTexture),o.memory.textures--),n.remove(mt[ft])}n.remove(N)}let V=0;function O(){V=0}function H(){return V}function Z(N){V=N}function $(){let N=V;return N>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),V+=1,N}function Y(N){let R=[];return R.push(N.wrapS),R.push(N.wrapT),R.push(N.wrapR||0),R.push(N.magFilter),R.push(N.minFilter),R.push(N.anisotropy),R.push(N.internalFormat),R.push(N.format),R.push(N.type),R.push(N.generateMipmaps),R.push(N.mipmapsAutoUpdate),R.push(N.premultiplyAlpha),R.push(N.flipY),R.push(N.unpackAlignment),R.push(N.colorSpace),R.join()}function it(N,R){let J=n.get(N);if(N.isVideoTexture&&Ie(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&J.__version!==N.version){let mt=N.image;if(mt===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{Me(J,N,R);return}}else N.isExternalTexture&&(J.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,J.__webglTexture,i.TEXTURE0+R)}function st(N,R){let J=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&J.__version!==N.version){Me(J,N,R);return}else N.isExternalTexture&&(J.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,J.__webglTexture,i.TEXTURE0+R)}function ot(N,R){let J=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&J.__version!==N.version){Me(J,N,R);return}e.bindTexture(i.TEXTURE_3D,J.__webglTexture,i.TEXTURE0+R)}function ut(N,R){let J=n.get(N);if(N.version>0&&J.__version!==N.version){$e(J,N,R);return}e.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture,i.TEXTURE0+R)}let Nt={[ic]:i.REPEAT,[Ji]:i.CLAMP_TO_EDGE,[sc]:i.MIRRORED_REPEAT},Ht={[Pn]:i.NEAREST,[Lg]:i.NEAREST_MIPMAP_NEAREST,[Oa]:i.NEAREST_MIPMAP_LINEAR,[Yn]:i.LINEAR,[Dc]:i.LINEAR_MIPMAP_NEAREST,[bs]:i.LINEAR_MIPMAP_LINEAR},It={[Fg]:i.NEVER,[Rf]:i.ALWAYS,[Og]:i.LESS,[Tf]:i.LEQUAL,[Bg]:i.EQUAL,[Af]:i.GEQUAL,[kg]:i.GREATER,[zg]:i.NOTEQUAL};function Zt(N,R){if(R.type===Oi&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Yn||R.magFilter===Dc||R.magFilter===Oa||R.magFilter===bs||R.minFilter===Yn||R.minFilter===Dc||R.minFilter===Oa||R.minFilter===bs)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(N,i.TEXTURE_WRAP_S,Nt[R.wrapS]),i.texParameteri(N,i.TEXTURE_WRAP_T,Nt[R.wrapT]),(N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY)&&i.texParameteri(N,i.TEXTURE_WRAP_R,Nt[R.wrapR]),i.texParameteri(N,i.TEXTURE_MAG_FILTER,Ht[R.magFilter]),i.texParameteri(N,i.TEXTURE_MIN_FILTER,Ht[R.minFilter]),R.compareFunction&&(i.texParameteri(N,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(N,i.TEXTURE_COMPARE_FUNC,It[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Pn||R.minFilter!==Oa&&R.minFilter!==bs||R.type===Oi&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||n.get(R).__currentAnisotropy){let J=t.get("EXT_texture_filter_anisotropic");i.texParameterf(N,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),n.get(R).__currentAnisotropy=R.anisotropy}}}function $t(N,R){let J=!1;N.__webglInit===void 0&&(N.__webglInit=!0,R.addEventListener("dispose",M),B(R));let mt=R.source,ft=p.get(mt);ft===void 0&&(ft={},p.set(mt,ft));let yt=Y(R);if(yt!==N.__cacheKey){ft[yt]===void 0&&(ft[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ft[yt].usedTimes++;let vt=ft[N.__cacheKey];vt!==void 0&&(ft[N.__cacheKey].usedTimes--,vt.usedTimes===0&&k(R)),N.__cacheKey=yt,N.__webglTexture=ft[yt].texture}return J}function Jt(N,R,J){return Math.floor(Math.floor(N/J)/R)}function Re(N,R,J,mt){let yt=N.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,R.width,R.height,J,mt,R.data);else{yt.sort((X,ht)=>X.start-ht.start);let vt=0;for(let X=1;X<yt.length;X++){let ht=yt[vt],lt=yt[X],Et=ht.start+ht.count,xt=Jt(lt.start,R.width,4),bt=Jt(ht.start,R.width,4);lt.start<=Et+1&&xt===bt&&Jt(lt.start+lt.count-1,R.width,4)===xt?ht.count=Math.max(ht.count,lt.start+lt.count-ht.start):(++vt,yt[vt]=lt)}yt.length=vt+1;let at=e.getParameter(i.UNPACK_ROW_LENGTH),ct=e.getParameter(i.UNPACK_SKIP_PIXELS),_t=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,R.width);for(let X=0,ht=yt.length;X<ht;X++){let lt=yt[X],Et=Math.floor(lt.start/4),xt=Math.ceil(lt.count/4),bt=Et%R.width,Wt=Math.floor(Et/R.width),te=xt,pt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Wt,te,pt,J,mt,R.data)}N.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,at),e.pixelStorei(i.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(i.UNPACK_SKIP_ROWS,_t)}}function Me(N,R,J){let mt=i.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=i.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=i.TEXTURE_3D);let ft=$t(N,R),yt=R.source;e.bindTexture(mt,N.__webglTexture,i.TEXTURE0+J);let vt=n.get(yt);if(yt.version!==vt.__version||ft===!0){if(e.activeTexture(i.TEXTURE0+J),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=ve.getPrimaries(ve.workingColorSpace),kt=R.colorSpace===Ts?null:ve.getPrimaries(R.colorSpace),ee=R.colorSpace===Ts||pt===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment);let ct=y(R.image,!1,s.maxTextureSize);ct=Vt(R,ct);let _t=r.convert(R.format,R.colorSpace),X=r.convert(R.type),ht=A(R.internalFormat,_t,X,R.normalized,R.colorSpace,R.isVideoTexture);Zt(mt,R);let lt,Et=R.mipmaps,xt=R.isVideoTexture!==!0,bt=vt.__version===void 0||ft===!0,Wt=yt.dataReady,te=T(R,ct);if(R.isDepthTexture)ht=_(R.format===Es,R.type),bt&&(xt?e.texStorage2D(i.TEXTURE_2D,1,ht,ct.width,ct.height):e.texImage2D(i.TEXTURE_2D,0,ht,ct.width,ct.height,0,_t,X,null));else if(R.isDataTexture)if(Et.length>0){xt&&bt&&e.texStorage2D(i.TEXTURE_2D,te,ht,Et[0].width,Et[0].height);for(let pt=0,kt=Et.length;pt<kt;pt++)lt=Et[pt],xt?Wt&&e.texSubImage2D(i.TEXTURE_2D,pt,0,0,lt.width,lt.height,_t,X,lt.data):e.texImage2D(i.TEXTURE_2D,pt,ht,lt.width,lt.height,0,_t,X,lt.data);R.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(i.TEXTURE_2D,te,ht,ct.width,ct.height),Wt&&Re(R,ct,_t,X)):e.texImage2D(i.TEXTURE_2D,0,ht,ct.width,ct.height,0,_t,X,ct.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,ht,Et[0].width,Et[0].height,ct.depth);for(let pt=0,kt=Et.length;pt<kt;pt++)if(lt=Et[pt],R.format!==ki)if(_t!==null)if(xt){if(Wt)if(R.layerUpdates.size>0){let ee=kf(lt.width,lt.height,R.format,R.type);for(let Ct of R.layerUpdates){let ae=lt.data.subarray(Ct*ee/lt.data.BYTES_PER_ELEMENT,(Ct+1)*ee/lt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pt,0,0,Ct,lt.width,lt.height,1,_t,ae)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pt,0,0,0,lt.width,lt.height,ct.depth,_t,lt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,pt,ht,lt.width,lt.height,ct.depth,0,lt.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,pt,0,0,0,lt.width,lt.height,ct.depth,_t,X,lt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,pt,ht,lt.width,lt.height,ct.depth,0,_t,X,lt.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(i.TEXTURE_2D,te,ht,Et[0].width,Et[0].height);for(let pt=0,kt=Et.length;pt<kt;pt++)lt=Et[pt],R.format!==ki?_t!==null?xt?Wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,pt,0,0,lt.width,lt.height,_t,lt.data):e.compressedTexImage2D(i.TEXTURE_2D,pt,ht,lt.width,lt.height,0,lt.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Wt&&e.texSubImage2D(i.TEXTURE_2D,pt,0,0,lt.width,lt.height,_t,X,lt.data):e.texImage2D(i.TEXTURE_2D,pt,ht,lt.width,lt.height,0,_t,X,lt.data)}else if(R.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,ht,ct.width,ct.height,ct.depth),Wt)if(R.layerUpdates.size>0){let pt=kf(ct.width,ct.height,R.format,R.type);for(let kt of R.layerUpdates){let ee=ct.data.subarray(kt*pt/ct.data.BYTES_PER_ELEMENT,(kt+1)*pt/ct.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,ct.width,ct.height,1,_t,X,ee)}R.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ct.width,ct.height,ct.depth,_t,X,ct.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ht,ct.width,ct.height,ct.depth,0,_t,X,ct.data);else if(R.isData3DTexture)xt?(bt&&e.texStorage3D(i.TEXTURE_3D,te,ht,ct.width,ct.height,ct.depth),Wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ct.width,ct.height,ct.depth,_t,X,ct.data)):e.texImage3D(i.TEXTURE_3D,0,ht,ct.width,ct.height,ct.depth,0,_t,X,ct.data);else if(R.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(i.TEXTURE_2D,te,ht,ct.width,ct.height);else{let pt=ct.width,kt=ct.height;for(let ee=0;ee<te;ee++)e.texImage2D(i.TEXTURE_2D,ee,ht,pt,kt,0,_t,X,null),pt>>=1,kt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in i){let pt=i.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),ct.parentNode!==pt){pt.appendChild(ct),h.add(R),pt.onpaint=kt=>{let ee=kt.changedElements;for(let Ct of h)ee.includes(Ct.image)&&(Ct.needsUpdate=!0)},pt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ct);else{let ee=i.RGBA,Ct=i.RGBA,ae=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ee,Ct,ae,ct)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(xt&&bt){let pt=qt(Et[0]);e.texStorage2D(i.TEXTURE_2D,te,ht,pt.width,pt.height)}for(let pt=0,kt=Et.length;pt<kt;pt++)lt=Et[pt],xt?Wt&&e.texSubImage2D(i.TEXTURE_2D,pt,0,0,_t,X,lt):e.texImage2D(i.TEXTURE_2D,pt,ht,_t,X,lt);R.generateMipmaps=!1}else if(xt){if(bt){let pt=qt(ct);e.texStorage2D(i.TEXTURE_2D,te,ht,pt.width,pt.height)}Wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,_t,X,ct)}else e.texImage2D(i.TEXTURE_2D,0,ht,_t,X,ct);b(R)&&R.mipmapsAutoUpdate===!0&&S(mt),vt.__version=yt.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function $e(N,R,J){if(R.image.length!==6)return;let mt=$t(N,R),ft=R.source;e.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+J);let yt=n.get(ft);if(ft.version!==yt.__version||mt===!0){e.activeTexture(i.TEXTURE0+J);let vt=ve.getPrimaries(ve.workingColorSpace),at=R.colorSpace===Ts?null:ve.getPrimaries(R.colorSpace),ct=R.colorSpace===Ts||vt===at?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ct);let _t=R.isCompressedTexture||R.image[0].isCompressedTexture,X=R.image[0]&&R.image[0].isDataTexture,ht=[];for(let Ct=0;Ct<6;Ct++)!_t&&!X?ht[Ct]=y(R.image[Ct],!0,s.maxCubemapSize):ht[Ct]=X?R.image[Ct].image:R.image[Ct],ht[Ct]=Vt(R,ht[Ct]);let lt=ht[0],Et=r.convert(R.format,R.colorSpace),xt=r.convert(R.type),bt=A(R.internalFormat,Et,xt,R.normalized,R.colorSpace),Wt=R.isVideoTexture!==!0,te=yt.__version===void 0||mt===!0,pt=ft.dataReady,kt=T(R,lt);Zt(i.TEXTURE_CUBE_MAP,R);let ee;if(R.isDepthTexture){if(bt=_(R.format===Es,R.type),te)if(Wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,lt.width,lt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,lt.width,lt.height,0,Et,xt,null)}else if(_t){Wt&&te&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,lt.width,lt.height);for(let Ct=0;Ct<6;Ct++){ee=ht[Ct].mipmaps;for(let ae=0;ae<ee.length;ae++){let ke=ee[ae];R.format!==ki?Et!==null?Wt?pt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ke.width,ke.height,Et,ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,bt,ke.width,ke.height,0,ke.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?pt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ke.width,ke.height,Et,xt,ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,bt,ke.width,ke.height,0,Et,xt,ke.data)}}}else{if(ee=R.mipmaps,Wt&&te){ee.length>0&&kt++;let Ct=qt(ht[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(X){Wt?pt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ht[Ct].width,ht[Ct].height,Et,xt,ht[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,ht[Ct].width,ht[Ct].height,0,Et,xt,ht[Ct].data);for(let ae=0;ae<ee.length;ae++){let kn=ee[ae].image[Ct].image;Wt?pt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,kn.width,kn.height,Et,xt,kn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,bt,kn.width,kn.height,0,Et,xt,kn.data)}}else{Wt?pt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,xt,ht[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Et,xt,ht[Ct]);for(let ae=0;ae<ee.length;ae++){let ke=ee[ae];Wt?pt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,Et,xt,ke.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,bt,Et,xt,ke.image[Ct])}}}b(R)&&R.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=ft.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function Se(N,R,J,mt,ft,yt){let vt=r.convert(J.format,J.colorSpace),at=r.convert(J.type),ct=A(J.internalFormat,vt,at,J.normalized,J.colorSpace),_t=n.get(R),X=n.get(J);if(X.__renderTarget=R,!_t.__hasExternalTextures){let ht=Math.max(1,R.width>>yt),lt=Math.max(1,R.height>>yt);ft===i.TEXTURE_3D||ft===i.TEXTURE_2D_ARRAY?e.texImage3D(ft,yt,ct,ht,lt,R.depth,0,vt,at,null):e.texImage2D(ft,yt,ct,ht,lt,0,vt,at,null)}e.bindFramebuffer(i.FRAMEBUFFER,N),wt(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,ft,X.__webglTexture,0,se(R)):(ft===i.TEXTURE_2D||ft>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ft<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,mt,ft,X.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function tn(N,R,J){if(i.bindRenderbuffer(i.RENDERBUFFER,N),R.depthBuffer){let mt=R.depthTexture,ft=mt&&mt.isDepthTexture?mt.type:null,yt=_(R.stencilBuffer,ft),vt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;wt(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(R),yt,R.width,R.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(R),yt,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,yt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,vt,i.RENDERBUFFER,N)}else{let mt=R.textures;for(let ft=0;ft<mt.length;ft++){let yt=mt[ft],vt=r.convert(yt.format,yt.colorSpace),at=r.convert(yt.type),ct=A(yt.internalFormat,vt,at,yt.normalized,yt.colorSpace);wt(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(R),ct,R.width,R.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(R),ct,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,ct,R.width,R.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function fe(N,R,J){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,N),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ft=n.get(R.depthTexture);ft.__renderTarget=R;let yt=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ft.__webglTexture||yt.width!==R.width||yt.height!==R.height)&&(yt.width=R.width,yt.height=R.height,R.depthTexture.needsUpdate=!0),mt?ut(R.depthTexture,0):it(R.depthTexture,0);let vt=ft.__webglTexture,at=se(R),ct=mt?i.TEXTURE_CUBE_MAP_POSITIVE_X+J:i.TEXTURE_2D,_t=R.depthTexture.format===Es?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(R.depthTexture.format===Ms)wt(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_t,ct,vt,0,at):i.framebufferTexture2D(i.FRAMEBUFFER,_t,ct,vt,0);else if(R.depthTexture.format===Es)wt(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_t,ct,vt,0,at):i.framebufferTexture2D(i.FRAMEBUFFER,_t,ct,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function hn(N){let R=n.get(N),J=N.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==N.depthTexture){let mt=N.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ft=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ft)};mt.addEventListener("dispose",ft),R.__depthDisposeCallback=ft}R.__boundDepthTexture=mt}if(N.depthTexture&&!R.__autoAllocateDepthBuffer)if(J)for(let mt=0;mt<6;mt++)fe(R.__webglFramebuffer[mt],N,mt);else N.texture.mipmaps.length>0?fe(R.__webglFramebuffer[0],N,0):fe(R.__webglFramebuffer,N,0);else if(J){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=i.createRenderbuffer(),tn(R.__webglDepthbuffer[mt],N,!1);else{let ft=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=R.__webglDepthbuffer[mt];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ft,i.RENDERBUFFER,yt)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=i.createRenderbuffer(),tn(R.__webglDepthbuffer,N,!1);else{let ft=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=R.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ft,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function je(N,R,J){let mt=n.get(N);R!==void 0&&Se(mt.__webglFramebuffer,N,N.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),J!==void 0&&hn(N)}function en(N){let R=N.texture,J=n.get(N),mt=n.get(R);N.addEventListener("dispose",L),B(N);let ft=N.textures,yt=N.isWebGLCubeRenderTarget===!0,vt=ft.length>1;if(vt||(mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture()),mt.__version=R.version,o.memory.textures++),yt){J.__webglFramebuffer=[];for(let at=0;at<6;at++)if(R.mipmaps.length>0){J.__webglFramebuffer[at]=[];for(let ct=0;ct<R.mipmaps.length;ct++)J.__webglFramebuffer[at][ct]=i.createFramebuffer()}else J.__webglFramebuffer[at]=i.createFramebuffer()}else{if(R.mipmaps.length>0){J.__webglFramebuffer=[];for(let at=0;at<R.mipmaps.length;at++)J.__webglFramebuffer[at]=i.createFramebuffer()}else J.__webglFramebuffer=i.createFramebuffer();if(vt)for(let at=0,ct=ft.length;at<ct;at++){let _t=n.get(ft[at]);_t.__webglTexture===void 0&&(_t.__webglTexture=i.createTexture(),o.memory.textures++)}if(N.samples>0&&wt(N)===!1){J.__webglMultisampledFramebuffer=i.createFramebuffer(),J.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let at=0;at<ft.length;at++){let ct=ft[at];J.__webglColorRenderbuffer[at]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,J.__webglColorRenderbuffer[at]);let _t=r.convert(ct.format,ct.colorSpace),X=r.convert(ct.type),ht=A(ct.internalFormat,_t,X,ct.normalized,ct.colorSpace,N.isXRRenderTarget===!0),lt=se(N);i.renderbufferStorageMultisample(i.RENDERBUFFER,lt,ht,N.width,N.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,J.__webglColorRenderbuffer[at])}i.bindRenderbuffer(i.RENDERBUFFER,null),N.depthBuffer&&(J.__webglDepthRenderbuffer=i.createRenderbuffer(),tn(J.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,mt.__webglTexture),Zt(i.TEXTURE_CUBE_MAP,R);for(let at=0;at<6;at++)if(R.mipmaps.length>0)for(let ct=0;ct<R.mipmaps.length;ct++)Se(J.__webglFramebuffer[at][ct],N,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+at,ct);else Se(J.__webglFramebuffer[at],N,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+at,0);b(R)?S(i.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let at=0,ct=ft.length;at<ct;at++){let _t=ft[at],X=n.get(_t),ht=i.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ht=N.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ht,X.__webglTexture),Zt(ht,_t),Se(J.__webglFramebuffer,N,_t,i.COLOR_ATTACHMENT0+at,ht,0),b(_t)&&S(ht)}e.unbindTexture()}else{let at=i.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(at=N.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(at,mt.__webglTexture),Zt(at,R),R.mipmaps.length>0)for(let ct=0;ct<R.mipmaps.length;ct++)Se(J.__webglFramebuffer[ct],N,R,i.COLOR_ATTACHMENT0,at,ct);else Se(J.__webglFramebuffer,N,R,i.COLOR_ATTACHMENT0,at,0);b(R)?S(at):R.mipmaps.length>0&&i.texParameteri(at,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&hn(N)}function W(N){let R=N.textures;for(let J=0,mt=R.length;J<mt;J++){let ft=R[J];if(b(ft)&&ft.mipmapsAutoUpdate===!0){let yt=E(N),vt=n.get(ft).__webglTexture;e.bindTexture(yt,vt),S(yt),e.unbindTexture()}}}let Rt=[];function jt(N){if(N.samples>0){if(wt(N)===!1){let R=N.textures,J=N.width,mt=N.height,ft=i.COLOR_BUFFER_BIT,yt=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=n.get(N),at=R.length>1;if(at)for(let _t=0;_t<R.length;_t++)e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let _t=0;_t<R.length;_t++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(ft|=i.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(ft|=i.STENCIL_BUFFER_BIT)),at){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,vt.__webglColorRenderbuffer[_t]);let X=n.get(R[_t]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,X,0)}i.blitFramebuffer(0,0,J,mt,0,0,J,mt,ft,i.NEAREST),l===!0&&(Rt.length=0,Rt.push(i.COLOR_ATTACHMENT0+_t),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Rt.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),at)for(let _t=0;_t<R.length;_t++){e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,vt.__webglColorRenderbuffer[_t]);let X=n.get(R[_t]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,X,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let R=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[R])}}}function se(N){return Math.min(s.maxSamples,N.samples)}function wt(N){let R=n.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Ie(N){let R=o.render.frame;f.get(N)!==R&&(f.set(N,R),N.update())}function Vt(N,R){let J=N.colorSpace,mt=N.format,ft=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||J!==ua&&J!==Ts&&(ve.getTransfer(J)===Pe?(mt!==ki||ft!==Qn)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ne("WebGLTextures: Unsupported texture color space:",J)),R}function qt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=$,this.resetTextureUnits=O,this.getTextureUnits=H,this.setTextureUnits=Z,this.setTexture2D=it,this.setTexture2DArray=st,this.setTexture3D=ot,this.setTextureCube=ut,this.rebindTextures=je,this.setupRenderTarget=en,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=hn,this.setupFrameBufferTexture=Se,this.useMultisampledRTT=wt,this.dispose=F}function l1(i,t){function e(n,s=Ts){let r,o=ve.getTransfer(s);if(n===Qn)return i.UNSIGNED_BYTE;if(n===Uc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Fc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Mf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Sf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yf)return i.BYTE;if(n===vf)return i.SHORT;if(n===Co)return i.UNSIGNED_SHORT;if(n===Nc)return i.INT;if(n===Fi)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===Bi)return i.HALF_FLOAT;if(n===wf)return i.ALPHA;if(n===bf)return i.RGB;if(n===ki)return i.RGBA;if(n===Ms)return i.DEPTH_COMPONENT;if(n===Es)return i.DEPTH_STENCIL;if(n===Ef)return i.RED;if(n===Oc)return i.RED_INTEGER;if(n===Ks)return i.RG;if(n===Bc)return i.RG_INTEGER;if(n===kc)return i.RGBA_INTEGER;if(n===Ba||n===ka||n===za||n===Va)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ba)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ba)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===zc||n===Vc||n===Gc||n===Hc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Vc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Gc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Hc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===Ga||n===jc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Wc||n===Xc)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Yc)return r.COMPRESSED_R11_EAC;if(n===$c)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ga)return r.COMPRESSED_RG11_EAC;if(n===jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Zc||n===Jc||n===Kc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Zc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Kc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===th)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===eh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===nh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ih)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===sh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===rh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===oh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ah)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===lh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ch)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===hh||n===uh||n===fh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===hh)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===fh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===dh||n===ph||n===Ha||n===mh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===dh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===ph)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ha)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var c1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,h1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,$f=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Ta(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ts({vertexShader:c1,fragmentShader:h1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Si(new Aa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jf=class extends Ui{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,f=null,h=null,u=null,p=null,m=null,x=typeof XRWebGLBinding<"u",g=new $f,d={},y=e.getContextAttributes(),b=null,S=null,E=[],A=[],_=new Yt,T=null,B=null,v=new qn;v.viewport=new Ke;let M=new qn;M.viewport=new Ke;let L=[v,M],I=new Cc,D=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let it=E[Y];return it===void 0&&(it=new Mo,E[Y]=it),it.getTargetRaySpace()},this.getControllerGrip=function(Y){let it=E[Y];return it===void 0&&(it=new Mo,E[Y]=it),it.getGripSpace()},this.getHand=function(Y){let it=E[Y];return it===void 0&&(it=new Mo,E[Y]=it),it.getHandSpace()};function G(Y){let it=A.indexOf(Y.inputSource);if(it===-1)return;let st=E[it];st!==void 0&&(st.update(Y.inputSource,Y.frame,c||o),st.dispatchEvent({type:Y.type,data:Y.inputSource}))}function k(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",tt);for(let Y=0;Y<E.length;Y++){let it=A[Y];it!==null&&(A[Y]=null,E[Y].disconnect(it))}D=null,F=null,g.reset();for(let Y in d)delete d[Y];if(t.setRenderTarget(b),p=null,u=null,h=null,s=null,S=null,$.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),B!==null){let Y=B.camera;Y.fov=B.fov,Y.zoom=B.zoom,Y.updateProjectionMatrix(),B=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,n.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,n.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",k),s.addEventListener("inputsourceschange",tt),y.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let st=null,ot=null,ut=null;y.depth&&(ut=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,st=y.stencil?Es:Ms,ot=y.stencil?wr:Fi);let Nt={colorFormat:e.RGBA8,depthFormat:ut,scaleFactor:r};h=this.getBinding(),u=h.createProjectionLayer(Nt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),S=new di(u.textureWidth,u.textureHeight,{format:ki,type:Qn,depthTexture:new ws(u.textureWidth,u.textureHeight,ot,void 0,void 0,void 0,void 0,void 0,void 0,st),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let st={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,st),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new di(p.framebufferWidth,p.framebufferHeight,{format:ki,type:Qn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),$.setContext(s),$.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function tt(Y){for(let it=0;it<Y.removed.length;it++){let st=Y.removed[it],ot=A.indexOf(st);ot>=0&&(A[ot]=null,E[ot].disconnect(st))}for(let it=0;it<Y.added.length;it++){let st=Y.added[it],ot=A.indexOf(st);if(ot===-1){for(let Nt=0;Nt<E.length;Nt++)if(Nt>=A.length){A.push(st),ot=Nt;break}else if(A[Nt]===null){A[Nt]=st,ot=Nt;break}if(ot===-1)break}let ut=E[ot];ut&&ut.connect(st)}}function V(Y,it){it===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(it.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let it=Y.near,st=Y.far;g.texture!==null&&(g.depthNear>0&&(it=g.depthNear),g.depthFar>0&&(st=g.depthFar)),I.near=M.near=v.near=it,I.far=M.far=v.far=st,(D!==I.near||F!==I.far)&&(s.updateRenderState({depthNear:I.near,depthFar:I.far}),D=I.near,F=I.far),I.layers.mask=Y.layers.mask|6,v.layers.mask=I.layers.mask&-5,M.layers.mask=I.layers.mask&-3;let ot=Y.parent,ut=I.cameras;V(I,ot);for(let Nt=0;Nt<ut.length;Nt++)V(ut[Nt],ot);I.projectionMatrix.copy(v.projectionMatrix),I.projectionMatrixInverse.copy(v.projectionMatrixInverse),B===null&&Y.isPerspectiveCamera&&(B={camera:Y,fov:Y.fov,zoom:Y.zoom}),O(Y,I,ot)};function O(Y,it,st){st===null?Y.matrix.copy(it.matrixWorld):(Y.matrix.copy(st.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(it.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(it.projectionMatrix),Y.projectionMatrixInverse.copy(it.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=yo*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return I},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(Y){l=Y,u!==null&&(u.fixedFoveation=Y),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Y)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(I)},this.getCameraTexture=function(Y){return d[Y]};let H=null;function Z(Y,it){if(f=it.getViewerPose(c||o),m=it,f!==null){let st=f.views;p!==null&&(t.setRenderTargetFramebuffer(S,p.framebuffer),t.setRenderTarget(S));let ot=!1;st.length!==I.cameras.length&&(I.cameras.length=0,ot=!0);for(let It=0;It<st.length;It++){let Zt=st[It],$t=null;if(p!==null)$t=p.getViewport(Zt);else{let Re=h.getViewSubImage(u,Zt);$t=Re.viewport,It===0&&(t.setRenderTargetTextures(S,Re.colorTexture,Re.depthStencilTexture),t.setRenderTarget(S))}let Jt=L[It];Jt===void 0&&(Jt=new qn,Jt.layers.enable(It),Jt.viewport=new Ke,L[It]=Jt),Jt.matrix.fromArray(Zt.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(Zt.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set($t.x,$t.y,$t.width,$t.height),It===0&&(I.matrix.copy(Jt.matrix),I.matrix.decompose(I.position,I.quaternion,I.scale)),ot===!0&&I.cameras.push(Jt)}let ut=s.enabledFeatures;if(ut&&ut.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=n.getBinding();let It=h.getDepthInformation(st[0]);It&&It.isValid&&It.texture&&g.init(It,s.renderState)}if(ut&&ut.includes("camera-access")&&x){t.state.unbindTexture(),h=n.getBinding();for(let It=0;It<st.length;It++){let Zt=st[It].camera;if(Zt){let $t=d[Zt];$t||($t=new Ta,d[Zt]=$t);let Jt=h.getCameraImage(Zt);$t.sourceTexture=Jt}}}}for(let st=0;st<E.length;st++){let ot=A[st],ut=E[st];ot!==null&&ut!==void 0&&ut.update(ot,it,c||o)}H&&H(Y,it),it.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:it}),m=null}let $=new _0;$.setAnimationLoop(Z),this.setAnimationLoop=function(Y){H=Y},this.dispose=function(){}}},u1=new Be,A0=new re;A0.set(-1,0,0,0,1,0,0,0,1);function f1(i,t){function e(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function n(g,d){d.color.getRGB(g.fogColor.value,Ff(i)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,y,b,S){d.isNodeMaterial?d.uniformsNeedUpdate=!1:d.isMeshBasicMaterial?r(g,d):d.isMeshLambertMaterial?(r(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshToonMaterial?(r(g,d),h(g,d)):d.isMeshPhongMaterial?(r(g,d),f(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshStandardMaterial?(r(g,d),u(g,d),d.isMeshPhysicalMaterial&&p(g,d,S)):d.isMeshMatcapMaterial?(r(g,d),m(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),x(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,y,b):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,e(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===jn&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,e(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===jn&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,e(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,e(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let y=t.get(d),b=y.envMap,S=y.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(u1.makeRotationFromEuler(S)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(A0),g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,y,b){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*y,g.scale.value=b*.5,d.map&&(g.map.value=d.map,e(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function f(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function h(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function u(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function p(g,d,y){g.ior.value=d.ior,d.diffuseRoughness>0&&(g.diffuseRoughness.value=d.diffuseRoughness,d.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=d.diffuseRoughnessMap,e(d.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===jn&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.retroreflectivity>0&&(g.retroreflectivity.value=d.retroreflectivity),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=d.iridescenceThicknessMaximum,d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,d){d.matcap&&(g.matcap.value=d.matcap)}function x(g,d){let y=t.get(d).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function d1(i,t,e,n){let s={},r={};function o(y,b){let S=b.program;n.uniformBlockBinding(y,S,s[y.id])}function a(y,b){let S=s[y.id];S===void 0&&(m(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",g));let E=b.program;n.updateUBOMapping(y,E);let A=t.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let b=i.createBuffer(),S=y.__size,E=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,b),i.bufferData(i.UNIFORM_BUFFER,S,E),i.bindBuffer(i.UNIFORM_BUFFER,null),b}function c(y){let b=s[y.id],S=y.uniforms,E=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let A=0,_=S.length;A<_;A++){let T=S[A];if(Array.isArray(T))for(let B=0,v=T.length;B<v;B++)f(T[B],A,B,E);else f(T,A,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(y,b,S,E){if(u(y,b,S,E)===!0){let A=y.__offset,_=y.value;if(Array.isArray(_)){let T=0;for(let B=0;B<_.length;B++){let v=_[B],M=x(v,!0);h(v,y.__data,T),T+=M.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function h(y,b,S){typeof y=="number"||typeof y=="boolean"?b[S]=y:y.isMatrix3?(b[S]=y.elements[0],b[S+1]=y.elements[1],b[S+2]=y.elements[2],b[S+3]=0,b[S+4]=y.elements[3],b[S+5]=y.elements[4],b[S+6]=y.elements[5],b[S+7]=0,b[S+8]=y.elements[6],b[S+9]=y.elements[7],b[S+10]=y.elements[8],b[S+11]=0):ArrayBuffer.isView(y)?b.set(y.subarray(0,b.length-S),S):y.toArray(b,S)}function u(y,b,S,E){let A=y.value,_=b+"_"+S;if(Array.isArray(A)){E[_]===void 0&&(E[_]=[]);let T=E[_],B=!1;for(let v=0;v<A.length;v++)p(A[v],T,v)===!0&&(B=!0);return B}return p(A,E,_)}function p(y,b,S){if(b[S]===void 0)return typeof y=="number"||typeof y=="boolean"?b[S]=y:ArrayBuffer.isView(y)?b[S]=y.slice():b[S]=y.clone(),!0;{let E=b[S];if(typeof y=="number"||typeof y=="boolean"){if(E!==y)return b[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(E.equals(y)===!1)return E.copy(y),!0}}return!1}function m(y){let b=y.uniforms,S=0,E=16;for(let _=0,T=b.length;_<T;_++){let B=Array.isArray(b[_])?b[_]:[b[_]];for(let v=0,M=B.length;v<M;v++){let L=B[v],I=Array.isArray(L.value)?L.value:[L.value],D=Array.isArray(b[_])||Array.isArray(L.value),F=S;for(let k=0,tt=I.length;k<tt;k++){let V=I[k],O=x(V,D),H=S%E,Z=H%O.boundary,$=H+Z;S+=Z,$!==0&&E-$<O.storage&&(S+=E-$),k===0&&(F=S),S+=O.storage}let G=L.type==="int"?Int32Array:L.type==="uint"?Uint32Array:Float32Array;L.__data=new G((S-F)/Float32Array.BYTES_PER_ELEMENT),L.__offset=F}}let A=S%E;return A>0&&(S+=E-A),y.__size=S,y.__cache={},this}function x(y,b){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",y),b===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(y){let b=y.target;b.removeEventListener("dispose",g),i.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function d(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:d}}var p1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function m1(){return ns===null&&(ns=new uc(p1,16,16,Ks,Bi),ns.name="DFG_LUT",ns.minFilter=Yn,ns.magFilter=Yn,ns.wrapS=Ji,ns.wrapT=Ji,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var Mh=class{constructor(t={}){let{canvas:e=Vg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:f="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:u=!1,outputBufferType:p=Qn}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let x=p,g=new Set([kc,Bc,Oc]),d=new Set([Qn,Fi,Co,wr,Uc,Fc]),y=new Uint32Array(4),b=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},E=null,A=null,_=[],T=[],B=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let v=this,M=!1,L=null,I=null,D=null,F=null;this._outputColorSpace=hi;let G=0,k=0,tt=null,V=-1,O=null,H=new Ke,Z=new Ke,$=null,Y=new he(0),it=0,st=e.width,ot=e.height,ut=1,Nt=null,Ht=null,It=new Ke(0,0,st,ot),Zt=new Ke(0,0,st,ot),$t=!1,Jt=new Xs,Re=new fc,Me=!1,$e=!1,Se=new Be,tn=new K,fe=new Ke,hn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},je=!1;function en(){return tt===null?ut:1}let W=n;function Rt(P,q){return e.getContext(P,q)}let jt,se,wt,Ie,Vt,qt,N,R,J,mt,ft,yt,vt,at,ct,_t,X,ht,lt,Et,xt,bt,Wt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:f,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),W===null){let q="webgl2";if(W=Rt(q,P),W===null)throw Rt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(P){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ne("WebGLRenderer: "+P.message),P}function te(){jt=new Tw(W),jt.init(),xt=new l1(W,jt),se=new mw(W,jt,t,xt),wt=new o1(W,jt),se.reversedDepthBuffer&&u&&wt.buffers.depth.setReversed(!0),I=W.createFramebuffer(),D=W.createFramebuffer(),F=W.createFramebuffer(),Ie=new Cw(W),Vt=new qb,qt=new a1(W,jt,wt,Vt,se,xt,Ie),N=new Ew(v),R=new Iv(W),bt=new dw(W,R),J=new Aw(W,R,Ie,bt),mt=new Iw(W,J,R,bt,Ie),ht=new Pw(W,se,qt),ct=new gw(Vt),ft=new Xb(v,N,jt,se,bt,ct),yt=new f1(v,Vt),vt=new $b,at=new t1(jt),X=new fw(v,N,wt,mt,m,l),_t=new r1(v,mt,se),Wt=new d1(W,Ie,se,wt),lt=new pw(W,jt,Ie),Et=new Rw(W,jt,Ie),Ie.programs=ft.programs,v.capabilities=se,v.extensions=jt,v.properties=Vt,v.renderLists=vt,v.shadowMap=_t,v.state=wt,v.info=Ie}x!==Qn&&(B=new Dw(x,e.width,e.height,a,s,r));let pt=new jf(v,W);this.xr=pt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let P=jt.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=jt.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return ut},this.setPixelRatio=function(P){P!==void 0&&(ut=P,this.setSize(st,ot,!1))},this.getSize=function(P){return P.set(st,ot)},this.setSize=function(P,q,rt=!0){if(pt.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}st=P,ot=q,e.width=Math.floor(P*ut),e.height=Math.floor(q*ut),rt===!0&&(e.style.width=P+"px",e.style.height=q+"px"),B!==null&&B.setSize(e.width,e.height),this.setViewport(0,0,P,q)},this.getDrawingBufferSize=function(P){return P.set(st*ut,ot*ut).floor()},this.setDrawingBufferSize=function(P,q,rt){st=P,ot=q,ut=rt,e.width=Math.floor(P*rt),e.height=Math.floor(q*rt),this.setViewport(0,0,P,q)},this.setEffects=function(P){if(x===Qn){ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let q=0;q<P.length;q++)if(P[q].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(H)},this.getViewport=function(P){return P.copy(It)},this.setViewport=function(P,q,rt,Q){P.isVector4?It.set(P.x,P.y,P.z,P.w):It.set(P,q,rt,Q),wt.viewport(H.copy(It).multiplyScalar(en()).round())},this.getScissor=function(P){return P.copy(Zt)},this.setScissor=function(P,q,rt,Q){P.isVector4?Zt.set(P.x,P.y,P.z,P.w):Zt.set(P,q,rt,Q),wt.scissor(Z.copy(Zt).multiplyScalar(en()).round())},this.getScissorTest=function(){return $t},this.setScissorTest=function(P){wt.setScissorTest($t=P)},this.setOpaqueSort=function(P){Nt=P},this.setTransparentSort=function(P){Ht=P},this.getClearColor=function(P){return P.copy(X.getClearColor())},this.setClearColor=function(){X.setClearColor(...arguments)},this.getClearAlpha=function(){return X.getClearAlpha()},this.setClearAlpha=function(){X.setClearAlpha(...arguments)},this.clear=function(P=!0,q=!0,rt=!0){let Q=0;if(P){let et=!1;if(tt!==null){let Tt=tt.texture.format;et=g.has(Tt)}if(et){let Tt=tt.texture.type,Pt=d.has(Tt),At=X.getClearColor(),Lt=X.getClearAlpha(),Gt=At.r,ie=At.g,de=At.b;Pt?(y[0]=Gt,y[1]=ie,y[2]=de,y[3]=Lt,W.clearBufferuiv(W.COLOR,0,y)):(b[0]=Gt,b[1]=ie,b[2]=de,b[3]=Lt,W.clearBufferiv(W.COLOR,0,b))}else Q|=W.COLOR_BUFFER_BIT}q&&(Q|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),rt&&(Q|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Q!==0&&W.clear(Q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),L=P},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),X.dispose(),vt.dispose(),at.dispose(),qt.dispose(),Vt.dispose(),N.dispose(),mt.dispose(),J.dispose(),bt.dispose(),Wt.dispose(),ft.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Za),pt.removeEventListener("sessionend",Vi),ss.stop()};function kt(P){P.preventDefault(),pa("WebGLRenderer: Context Lost."),M=!0}function ee(){pa("WebGLRenderer: Context Restored."),M=!1;let P=Ie.autoReset,q=_t.enabled,rt=_t.autoUpdate,Q=_t.needsUpdate,et=_t.type;te(),Ie.autoReset=P,_t.enabled=q,_t.autoUpdate=rt,_t.needsUpdate=Q,_t.type=et}function Ct(P){ne("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function ae(P){let q=P.target;q.removeEventListener("dispose",ae),ke(q)}function ke(P){kn(P),Vt.remove(P)}function kn(P){let q=Vt.get(P).programs;q!==void 0&&(q.forEach(function(rt){ft.releaseProgram(rt)}),P.isShaderMaterial&&ft.releaseShaderCache(P))}this.renderBufferDirect=function(P,q,rt,Q,et,Tt){q===null&&(q=hn);let Pt=et.isMesh&&et.matrixWorld.determinantAffine()<0,At=zo(P,q,rt,Q,et);wt.setMaterial(Q,Pt);let Lt=rt.index,Gt=1;if(Q.wireframe===!0){if(Lt=J.getWireframeAttribute(rt),Lt===void 0)return;Gt=2}let ie=rt.drawRange,de=rt.attributes.position,zt=ie.start*Gt,pe=(ie.start+ie.count)*Gt;Tt!==null&&(zt=Math.max(zt,Tt.start*Gt),pe=Math.min(pe,(Tt.start+Tt.count)*Gt)),Lt!==null?(zt=Math.max(zt,0),pe=Math.min(pe,Lt.count)):de!=null&&(zt=Math.max(zt,0),pe=Math.min(pe,de.count));let Qe=pe-zt;if(Qe<0||Qe===1/0)return;bt.setup(et,Q,At,rt,Lt);let Le,De=lt;if(Lt!==null&&(Le=R.get(Lt),De=Et,De.setIndex(Le)),et.isMesh)Q.wireframe===!0?(wt.setLineWidth(Q.wireframeLinewidth*en()),De.setMode(W.LINES)):De.setMode(W.TRIANGLES);else if(et.isLine){let yn=Q.linewidth;yn===void 0&&(yn=1),wt.setLineWidth(yn*en()),et.isLineSegments?De.setMode(W.LINES):et.isLineLoop?De.setMode(W.LINE_LOOP):De.setMode(W.LINE_STRIP)}else et.isPoints?De.setMode(W.POINTS):et.isSprite&&De.setMode(W.TRIANGLES);if(et.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))De.renderMultiDraw(et._multiDrawStarts,et._multiDrawCounts,et._multiDrawCount);else{let yn=et._multiDrawStarts,Ot=et._multiDrawCounts,dn=et._multiDrawCount,xe=Lt?R.get(Lt).bytesPerElement:1,os=Vt.get(Q).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)os.setValue(W,"_gl_DrawID",pn),De.render(yn[pn]/xe,Ot[pn])}else if(et.isInstancedMesh)De.renderInstances(zt,Qe,et.count);else if(rt.isInstancedBufferGeometry){let yn=rt._maxInstanceCount!==void 0?rt._maxInstanceCount:1/0,Ot=Math.min(rt.instanceCount,yn);De.renderInstances(zt,Qe,Ot)}else De.render(zt,Qe)};function Oo(P,q,rt,Q){L!==null&&P.isNodeMaterial&&L.setObject(Q,P),Me===!0&&ct.setState(P,rt,!1),P.transparent===!0&&P.side===wi&&P.forceSinglePass===!1?(P.side=jn,P.needsUpdate=!0,Gi(P,q,Q),P.side=Js,P.needsUpdate=!0,Gi(P,q,Q),P.side=wi):Gi(P,q,Q)}this.compile=function(P,q,rt=null){rt===null&&(rt=P),L!==null&&L.renderStart(P,q,rt),A=at.get(rt),A.init(q),T.push(A),rt.traverseVisible(function(et){et.isLight&&et.layers.test(q.layers)&&(A.pushLight(et),et.castShadow&&A.pushShadow(et))}),P!==rt&&P.traverseVisible(function(et){et.isLight&&et.layers.test(q.layers)&&(A.pushLight(et),et.castShadow&&A.pushShadow(et))}),A.setupLights(),L!==null&&L.updateLights(A.state.lightsArray),$e=this.localClippingEnabled,Me=ct.init(this.clippingPlanes,$e),Me===!0&&ct.setGlobalState(this.clippingPlanes,q),L!==null&&_t.render(A.state.shadowsArray,rt,q);let Q=new Set;return P.traverse(function(et){if(!(et.isMesh||et.isPoints||et.isLine||et.isSprite))return;let Tt=et.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let At=Tt[Pt];Oo(At,rt,q,et),Q.add(At)}else Oo(Tt,rt,q,et),Q.add(Tt)}),A=T.pop(),L!==null&&L.renderEnd(),Q},this.compileAsync=function(P,q,rt=null){let Q=this.compile(P,q,rt);return new Promise(et=>{function Tt(){if(Q.forEach(function(Pt){let Lt=Vt.get(Pt).currentProgram;(Lt===void 0||Lt.isReady())&&Q.delete(Pt)}),Q.size===0){et(P);return}setTimeout(Tt,10)}jt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Ar=null;function Fh(P){Ar&&Ar(P)}function Za(){ss.stop()}function Vi(){ss.start()}let ss=new _0;ss.setAnimationLoop(Fh),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(P){Ar=P,pt.setAnimationLoop(P),P===null?ss.stop():ss.start()},pt.addEventListener("sessionstart",Za),pt.addEventListener("sessionend",Vi),this.render=function(P,q){if(q!==void 0&&q.isCamera!==!0){ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(M===!0)return;L!==null&&L.renderStart(P,q);let rt=pt.enabled===!0&&pt.isPresenting===!0,Q=B!==null&&(tt===null||rt)&&B.begin(v,tt);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),P.isScene===!0&&P.onBeforeRender(v,P,q,tt),A=at.get(P,T.length),A.init(q),A.state.textureUnits=qt.getTextureUnits(),T.push(A),Se.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?Re.setFromArrayCamera(q):Jt.setFromProjectionMatrix(Se,Mi,q.reversedDepth),$e=this.localClippingEnabled,Me=ct.init(this.clippingPlanes,$e),E=vt.get(P,_.length),E.init(),_.push(E),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Pt=v.xr.getDepthSensingMesh();Pt!==null&&rs(Pt,q,-1/0,v.sortObjects)}rs(P,q,0,v.sortObjects),E.finish(),L!==null&&L.updateLights(A.state.lightsArray),v.sortObjects===!0&&E.sort(Nt,Ht),je=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,je&&X.addToRenderList(E,P),this.info.autoReset===!0&&this.info.reset(),Me===!0&&ct.beginShadows();let et=A.state.shadowsArray;if(_t.render(et,P,q),Me===!0&&ct.endShadows(),(Q&&B.hasRenderPass())===!1){let Pt=E.opaque,At=E.transmissive;if(A.setupLights(),q.isArrayCamera){let Lt=q.cameras;if(At.length>0)for(let Gt=0,ie=Lt.length;Gt<ie;Gt++){let de=Lt[Gt];Ti(Pt,At,P,de)}je&&X.render(P);for(let Gt=0,ie=Lt.length;Gt<ie;Gt++){let de=Lt[Gt];Bo(E,P,de,de.viewport)}}else At.length>0&&Ti(Pt,At,P,q),je&&X.render(P),Bo(E,P,q)}tt!==null&&k===0&&(qt.updateMultisampleRenderTarget(tt),qt.updateRenderTargetMipmap(tt)),Q&&B.end(v),P.isScene===!0&&P.onAfterRender(v,P,q),bt.resetDefaultState(),V=-1,O=null,T.pop(),T.length>0?(A=T[T.length-1],qt.setTextureUnits(A.state.textureUnits),Me===!0&&ct.setGlobalState(v.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?E=_[_.length-1]:E=null,L!==null&&L.renderEnd()};function rs(P,q,rt,Q){if(P.visible===!1)return;if(P.layers.test(q.layers)){if(P.isGroup)rt=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update(q);else if(P.isLight)A.pushLight(P),P.castShadow&&A.pushShadow(P);else if(P.isSprite){let Pt=q.isArrayCamera?Re:Jt;if(!P.frustumCulled||P.intersectsFrustum(Pt)){Q&&fe.setFromMatrixPosition(P.matrixWorld).applyMatrix4(Se);let At=mt.update(P),Lt=P.material;Lt.visible&&E.push(P,At,Lt,rt,fe.z,null,q)}}else if(P.isMesh||P.isLine||P.isPoints){let Pt=q.isArrayCamera?Re:Jt;if(!P.frustumCulled||P.intersectsFrustum(Pt)){let At=mt.update(P),Lt=P.material;if(Q&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),fe.copy(P.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),fe.copy(At.boundingSphere.center)),fe.applyMatrix4(P.matrixWorld).applyMatrix4(Se)),Array.isArray(Lt)){let Gt=At.groups;for(let ie=0,de=Gt.length;ie<de;ie++){let zt=Gt[ie],pe=Lt[zt.materialIndex];pe&&pe.visible&&E.push(P,At,pe,rt,fe.z,zt,q)}}else Lt.visible&&E.push(P,At,Lt,rt,fe.z,null,q)}}}let Tt=P.children;for(let Pt=0,At=Tt.length;Pt<At;Pt++)rs(Tt[Pt],q,rt,Q)}function Bo(P,q,rt,Q){let{opaque:et,transmissive:Tt,transparent:Pt}=P;A.setupLightsView(rt),Me===!0&&ct.setGlobalState(v.clippingPlanes,rt),Q&&wt.viewport(H.copy(Q)),et.length>0&&nn(et,q,rt),Tt.length>0&&nn(Tt,q,rt),Pt.length>0&&nn(Pt,q,rt),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ti(P,q,rt,Q){if((rt.isScene===!0?rt.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Q.id]===void 0){let zt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Q.id]=new di(1,1,{generateMipmaps:!0,type:zt?Bi:Qn,minFilter:bs,samples:Math.max(4,se.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let Tt=A.state.transmissionRenderTarget[Q.id],Pt=Q.viewport||H;Tt.setSize(Pt.z*v.transmissionResolutionScale,Pt.w*v.transmissionResolutionScale);let At=v.getRenderTarget(),Lt=v.getActiveCubeFace(),Gt=v.getActiveMipmapLevel();v.setRenderTarget(Tt),v.getClearColor(Y),it=v.getClearAlpha(),it<1&&v.setClearColor(16777215,.5),v.clear(),je&&X.render(rt);let ie=v.toneMapping;v.toneMapping=es;let de=Q.viewport;if(Q.viewport!==void 0&&(Q.viewport=void 0),A.setupLightsView(Q),Me===!0&&ct.setGlobalState(v.clippingPlanes,Q),nn(P,rt,Q),qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt),jt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let pe=0,Qe=q.length;pe<Qe;pe++){let Le=q[pe],{object:De,geometry:yn,material:Ot,group:dn}=Le;if(Ot.side===wi&&De.layers.test(Q.layers)){let xe=Ot.side;Ot.side=jn,Ot.needsUpdate=!0,un(De,rt,Q,yn,Ot,dn),Ot.side=xe,Ot.needsUpdate=!0,zt=!0}}zt===!0&&(qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt))}v.setRenderTarget(At,Lt,Gt),v.setClearColor(Y,it),de!==void 0&&(Q.viewport=de),v.toneMapping=ie}function nn(P,q,rt){let Q=q.isScene===!0?q.overrideMaterial:null;for(let et=0,Tt=P.length;et<Tt;et++){let Pt=P[et],{object:At,geometry:Lt,group:Gt}=Pt,ie=Pt.material;ie.allowOverride===!0&&Q!==null&&(ie=Q),At.layers.test(rt.layers)&&un(At,q,rt,Lt,ie,Gt)}}function un(P,q,rt,Q,et,Tt){L!==null&&et.isNodeMaterial&&L.setObject(P,et),P.onBeforeRender(v,q,rt,Q,et,Tt),P.modelViewMatrix.multiplyMatrices(rt.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),et.onBeforeRender(v,q,rt,Q,P,Tt),et.transparent===!0&&et.side===wi&&et.forceSinglePass===!1?(et.side=jn,et.needsUpdate=!0,v.renderBufferDirect(rt,q,Q,et,P,Tt),et.side=Js,et.needsUpdate=!0,v.renderBufferDirect(rt,q,Q,et,P,Tt),et.side=wi):v.renderBufferDirect(rt,q,Q,et,P,Tt),P.onAfterRender(v,q,rt,Q,et,Tt)}function fn(P){let q=0;for(let rt of P)rt.texture!==null&&q++;return q}function Gi(P,q,rt){q.isScene!==!0&&(q=hn);let Q=Vt.get(P),et=A.state.lights,Tt=A.state.shadowsArray,Pt=et.state.version,At=ft.getParameters(P,et.state,Tt,q,rt,A.state.lightProbeGridArray),Lt=ft.getProgramCacheKey(At),Gt=Q.programs;Q.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?q.environment:null,Q.fog=q.fog;let ie=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;Q.envMap=N.get(P.envMap||Q.environment,ie),Q.envMapRotation=Q.environment!==null&&P.envMap===null?q.environmentRotation:P.envMapRotation,Gt===void 0&&(P.addEventListener("dispose",ae),Gt=new Map,Q.programs=Gt,Q.programVariants=new Map);let de=Gt.get(Lt);if(de!==void 0){if(Q.currentProgram===de&&Q.lightsStateVersion===Pt)return ko(P,At),de}else At.uniforms=ft.getUniforms(P),L!==null&&P.isNodeMaterial&&L.build(P,rt,At),P.onBeforeCompile(At,v),de=ft.acquireProgram(At,Lt),Gt.set(Lt,de),Q.uniforms=At.uniforms;let zt=Q.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(zt.clippingPlanes=ct.uniform),ko(P,At),Q.needsLights=Cs(P),Q.lightsStateVersion=Pt,Q.needsLights&&(zt.ambientLightColor.value=et.state.ambient,zt.lightProbe.value=et.state.probe,zt.sunLights.value=et.state.sun,zt.sunLightShadows.value=et.state.sunShadow,zt.directionalLights.value=et.state.directional,zt.directionalLightShadows.value=et.state.directionalShadow,zt.spotLights.value=et.state.spot,zt.spotLightShadows.value=et.state.spotShadow,zt.rectAreaLights.value=et.state.rectArea,zt.ltc_1.value=et.state.rectAreaLTC1,zt.ltc_2.value=et.state.rectAreaLTC2,zt.pointLights.value=et.state.point,zt.pointLightShadows.value=et.state.pointShadow,zt.hemisphereLights.value=et.state.hemi,zt.sunShadowMatrix.value=et.state.sunShadowMatrix,zt.sunShadowCascade.value=et.state.sunShadowCascade,zt.directionalShadowMatrix.value=et.state.directionalShadowMatrix,zt.spotLightMatrix.value=et.state.spotLightMatrix,zt.spotLightMap.value=et.state.spotLightMap,zt.pointShadowMatrix.value=et.state.pointShadowMatrix),Q.numLightProbeGrids=fn(A.state.lightProbeGridArray),Q.currentProgram=de,Q.uniformsList=null,de}function ei(P,q,rt,Q,et){let Tt=Vt.get(P),Pt=Tt.currentProgram.id+","+Q+","+et,At=Tt.programVariants.get(Pt);return At===void 0?(At=Gi(P,q,rt),Tt.programVariants.set(Pt,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=Q,Tt.toneMapping=et),At}function Rs(P){if(P.uniformsList===null){let q=P.currentProgram.getUniforms();P.uniformsList=Po.seqWithValue(q.seq,P.uniforms)}return P.uniformsList}function ko(P,q){let rt=Vt.get(P);rt.outputColorSpace=q.outputColorSpace,rt.batching=q.batching,rt.batchingColor=q.batchingColor,rt.instancing=q.instancing,rt.instancingColor=q.instancingColor,rt.instancingMorph=q.instancingMorph,rt.skinning=q.skinning,rt.morphTargets=q.morphTargets,rt.morphNormals=q.morphNormals,rt.morphColors=q.morphColors,rt.morphTargetsCount=q.morphTargetsCount,rt.numClippingPlanes=q.numClippingPlanes,rt.numIntersection=q.numClipIntersection,rt.vertexAlphas=q.vertexAlphas,rt.vertexTangents=q.vertexTangents,rt.toneMapping=q.toneMapping}function zo(P,q,rt,Q,et){q.isScene!==!0&&(q=hn),qt.resetTextureUnits();let Tt=q.fog,Pt=Q.isMeshStandardMaterial||Q.isMeshLambertMaterial||Q.isMeshPhongMaterial?q.environment:null,At=tt===null?v.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:ve.workingColorSpace,Lt=Q.isMeshStandardMaterial||Q.isMeshLambertMaterial&&!Q.envMap||Q.isMeshPhongMaterial&&!Q.envMap,Gt=N.get(Q.envMap||Pt,Lt),ie=Q.vertexColors===!0&&!!rt.attributes.color&&rt.attributes.color.itemSize===4,de=!!rt.attributes.tangent&&(!!Q.normalMap||Q.anisotropy>0),zt=!!rt.morphAttributes.position,pe=!!rt.morphAttributes.normal,Qe=!!rt.morphAttributes.color,Le=es;Q.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(Le=v.toneMapping);let De=rt.morphAttributes.position||rt.morphAttributes.normal||rt.morphAttributes.color,yn=De!==void 0?De.length:0,Ot=Vt.get(Q),dn=A.state.lights;if(Me===!0&&($e===!0||P!==O)){let Ne=P===O&&Q.id===V;ct.setState(Q,P,Ne)}let xe=!1,os=!1;Q.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==dn.state.version||et.isBatchedMesh&&Ot.batching===!1||!et.isBatchedMesh&&Ot.batching===!0||et.isBatchedMesh&&Ot.batchingColor===!0&&et._colorsTexture===null||et.isBatchedMesh&&Ot.batchingColor===!1&&et._colorsTexture!==null||et.isInstancedMesh&&Ot.instancing===!1||!et.isInstancedMesh&&Ot.instancing===!0||et.isSkinnedMesh&&Ot.skinning===!1||!et.isSkinnedMesh&&Ot.skinning===!0||et.isInstancedMesh&&Ot.instancingColor===!0&&et.instanceColor===null||et.isInstancedMesh&&Ot.instancingColor===!1&&et.instanceColor!==null||et.isInstancedMesh&&Ot.instancingMorph===!0&&et.morphTexture===null||et.isInstancedMesh&&Ot.instancingMorph===!1&&et.morphTexture!==null||Ot.envMap!==Gt||Q.fog===!0&&Ot.fog!==Tt||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==ct.numPlanes||Ot.numIntersection!==ct.numIntersection)||Ot.vertexAlphas!==ie||Ot.vertexTangents!==de||Ot.morphTargets!==zt||Ot.morphNormals!==pe||Ot.morphColors!==Qe||Ot.morphTargetsCount!==yn||Ot.numLightProbeGrids!==fn(A.state.lightProbeGridArray)?xe=!0:(Ot.outputColorSpace!==At||Ot.toneMapping!==Le)&&(os=!0):(xe=!0,Ot.__version=Q.version);let pn=Ot.currentProgram;(xe===!0||os===!0)&&(pn=os===!0?ei(Q,q,et,At,Le):Gi(Q,q,et),L&&Q.isNodeMaterial&&L.onUpdateProgram(Q,pn,Ot));let Pr=!1,Hi=!1,as=!1,ce=pn.getUniforms(),sn=Ot.uniforms;if(wt.useProgram(pn.program)&&(Pr=!0,Hi=!0,as=!0),Q.id!==V&&(V=Q.id,Hi=!0),Pr||O!==P){wt.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),ce.setValue(W,"projectionMatrix",P.projectionMatrix),ce.setValue(W,"viewMatrix",P.matrixWorldInverse);let mn=ce.map.cameraPosition;mn!==void 0&&mn.setValue(W,tn.setFromMatrixPosition(P.matrixWorld)),se.logarithmicDepthBuffer&&ce.setValue(W,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(Q.isMeshPhongMaterial||Q.isMeshToonMaterial||Q.isMeshLambertMaterial||Q.isMeshBasicMaterial||Q.isMeshStandardMaterial||Q.isShaderMaterial)&&ce.setValue(W,"isOrthographic",P.isOrthographicCamera===!0),O!==P&&(O=P,Hi=!0,as=!0)}if(Ot.needsLights&&(dn.state.sunShadowMap.length>0&&ce.setValue(W,"sunShadowMap",dn.state.sunShadowMap,qt),dn.state.directionalShadowMap.length>0&&ce.setValue(W,"directionalShadowMap",dn.state.directionalShadowMap,qt),dn.state.spotShadowMap.length>0&&ce.setValue(W,"spotShadowMap",dn.state.spotShadowMap,qt),dn.state.pointShadowMap.length>0&&ce.setValue(W,"pointShadowMap",dn.state.pointShadowMap,qt)),et.isSkinnedMesh){ce.setOptional(W,et,"bindMatrix"),ce.setOptional(W,et,"bindMatrixInverse");let Ne=et.skeleton;Ne&&(Ne.boneTexture===null&&Ne.computeBoneTexture(),ce.setValue(W,"boneTexture",Ne.boneTexture,qt))}et.isBatchedMesh&&(ce.setOptional(W,et,"batchingTexture"),ce.setValue(W,"batchingTexture",et._matricesTexture,qt),ce.setOptional(W,et,"batchingIdTexture"),ce.setValue(W,"batchingIdTexture",et._indirectTexture,qt),ce.setOptional(W,et,"batchingColorTexture"),et._colorsTexture!==null&&ce.setValue(W,"batchingColorTexture",et._colorsTexture,qt));let zn=rt.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&ht.update(et,rt,pn),(Hi||Ot.receiveShadow!==et.receiveShadow)&&(Ot.receiveShadow=et.receiveShadow,ce.setValue(W,"receiveShadow",et.receiveShadow)),(Q.isMeshStandardMaterial||Q.isMeshLambertMaterial||Q.isMeshPhongMaterial)&&Q.envMap===null&&q.environment!==null&&(sn.envMapIntensity.value=q.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=m1()),Hi){if(ce.setValue(W,"toneMappingExposure",v.toneMappingExposure),Ot.needsLights&&Rr(sn,as),Tt&&Q.fog===!0&&yt.refreshFogUniforms(sn,Tt),yt.refreshMaterialUniforms(sn,Q,ut,ot,A.state.transmissionRenderTarget[P.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Ne=S,mn=0;for(let Nn of A.state.lightProbeGridArray)Nn.texture!==null&&(Ne.textures[mn]=Nn.texture,Ne.min[mn]=Nn.boundingBox.min,Ne.max[mn]=Nn.boundingBox.max,Ne.resolution[mn]=Nn.resolution,mn++);for(let Nn in Ne)Ne[Nn].length=mn;sn.probesSH.value=Ne.textures,sn.probesMin.value=Ne.min,sn.probesMax.value=Ne.max,sn.probesResolution.value=Ne.resolution}Po.upload(W,Rs(Ot),sn,qt)}if(Q.isShaderMaterial&&Q.uniformsNeedUpdate===!0&&(Po.upload(W,Rs(Ot),sn,qt),Q.uniformsNeedUpdate=!1),Q.isSpriteMaterial&&ce.setValue(W,"center",et.center),ce.setValue(W,"modelViewMatrix",et.modelViewMatrix),ce.setValue(W,"normalMatrix",et.normalMatrix),ce.setValue(W,"modelMatrix",et.matrixWorld),Q.uniformsGroups!==void 0){let Ne=Q.uniformsGroups;for(let mn=0,Nn=Ne.length;mn<Nn;mn++){let Ja=Ne[mn];Wt.update(Ja,pn),Wt.bind(Ja,pn)}}return pn}function Rr(P,q){P.ambientLightColor.needsUpdate=q,P.lightProbe.needsUpdate=q,P.sunLights.needsUpdate=q,P.sunLightShadows.needsUpdate=q,P.directionalLights.needsUpdate=q,P.directionalLightShadows.needsUpdate=q,P.pointLights.needsUpdate=q,P.pointLightShadows.needsUpdate=q,P.spotLights.needsUpdate=q,P.spotLightShadows.needsUpdate=q,P.rectAreaLights.needsUpdate=q,P.hemisphereLights.needsUpdate=q}function Cs(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(P,q,rt){let Q=Vt.get(P);Q.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,Q.__autoAllocateDepthBuffer===!1&&(Q.__useRenderToTexture=!1),Vt.get(P.texture).__webglTexture=q,Vt.get(P.depthTexture).__webglTexture=Q.__autoAllocateDepthBuffer?void 0:rt,Q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,q){let rt=Vt.get(P);rt.__webglFramebuffer=q,rt.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(P,q=0,rt=0){tt=P,G=q,k=rt;let Q=null,et=!1,Tt=!1;if(P){let At=Vt.get(P);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(W.FRAMEBUFFER,At.__webglFramebuffer),H.copy(P.viewport),Z.copy(P.scissor),$=P.scissorTest,wt.viewport(H),wt.scissor(Z),wt.setScissorTest($),V=-1;return}else if(At.__webglFramebuffer===void 0)qt.setupRenderTarget(P);else if(At.__hasExternalTextures)qt.rebindTextures(P,Vt.get(P.texture).__webglTexture,Vt.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let ie=P.depthTexture;if(At.__boundDepthTexture!==ie){if(ie!==null&&Vt.has(ie)&&(P.width!==ie.image.width||P.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(P)}}let Lt=P.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Gt=Vt.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Gt[q])?Q=Gt[q][rt]:Q=Gt[q],et=!0):P.samples>0&&qt.useMultisampledRTT(P)===!1?Q=Vt.get(P).__webglMultisampledFramebuffer:Array.isArray(Gt)?Q=Gt[rt]:Q=Gt,H.copy(P.viewport),Z.copy(P.scissor),$=P.scissorTest}else H.copy(It).multiplyScalar(ut).floor(),Z.copy(Zt).multiplyScalar(ut).floor(),$=$t;if(rt!==0&&(Q=I),wt.bindFramebuffer(W.FRAMEBUFFER,Q)&&wt.drawBuffers(P,Q),wt.viewport(H),wt.scissor(Z),wt.setScissorTest($),et){let At=Vt.get(P.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+q,At.__webglTexture,rt)}else if(Tt){let At=q;for(let Lt=0;Lt<P.textures.length;Lt++){let Gt=Vt.get(P.textures[Lt]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Lt,Gt.__webglTexture,rt,At)}}else if(P!==null&&rt!==0){let At=Vt.get(P.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,At.__webglTexture,rt)}V=-1};function Cr(P){let q=Vt.get(P);return(q.__readFormat!==P.format||q.__readType!==P.type)&&(q.__readFormat=P.format,q.__readType=P.type,q.__formatReadable=se.textureFormatReadable(P.format),q.__typeReadable=se.textureTypeReadable(P.type)),q}this.readRenderTargetPixels=function(P,q,rt,Q,et,Tt,Pt,At=0){if(!(P&&P.isWebGLRenderTarget)){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Vt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pt!==void 0&&(Lt=Lt[Pt],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){wt.bindFramebuffer(W.FRAMEBUFFER,Lt);try{let Gt=P.textures[At],ie=Gt.format,de=Gt.type;P.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+At);let zt=Cr(Gt);if(zt.__formatReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=P.width-Q&&rt>=0&&rt<=P.height-et&&W.readPixels(q,rt,Q,et,xt.convert(ie),xt.convert(de),Tt)}finally{let Gt=tt!==null?Vt.get(tt).__webglFramebuffer:null;wt.bindFramebuffer(W.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(P,q,rt,Q,et,Tt,Pt,At=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Vt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pt!==void 0&&(Lt=Lt[Pt],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(q>=0&&q<=P.width-Q&&rt>=0&&rt<=P.height-et){wt.bindFramebuffer(W.FRAMEBUFFER,Lt);let Gt=P.textures[At],ie=Gt.format,de=Gt.type;P.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+At);let zt=Cr(Gt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,pe),W.bufferData(W.PIXEL_PACK_BUFFER,Tt.byteLength,W.STREAM_READ),W.readPixels(q,rt,Q,et,xt.convert(ie),xt.convert(de),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let Qe=tt!==null?Vt.get(tt).__webglFramebuffer:null;wt.bindFramebuffer(W.FRAMEBUFFER,Qe);let Le=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await Hg(W,Le,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,pe),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,Tt),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(pe),W.deleteSync(Le),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,q=null,rt=0){let Q=Math.pow(2,-rt),et=Math.floor(P.image.width*Q),Tt=Math.floor(P.image.height*Q),Pt=q!==null?q.x:0,At=q!==null?q.y:0;qt.setTexture2D(P,0),W.copyTexSubImage2D(W.TEXTURE_2D,rt,0,0,Pt,At,et,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(P,q,rt=null,Q=null,et=0,Tt=0){let Pt,At,Lt,Gt,ie,de,zt,pe,Qe,Le=P.isCompressedTexture?P.mipmaps[Tt]:P.image;if(rt!==null)Pt=rt.max.x-rt.min.x,At=rt.max.y-rt.min.y,Lt=rt.isBox3?rt.max.z-rt.min.z:1,Gt=rt.min.x,ie=rt.min.y,de=rt.isBox3?rt.min.z:0;else{let ce=Math.pow(2,-et);Pt=Math.floor(Le.width*ce),At=Math.floor(Le.height*ce),P.isDataArrayTexture?Lt=Le.depth:P.isData3DTexture?Lt=Math.floor(Le.depth*ce):Lt=1,Gt=0,ie=0,de=0}Q!==null?(zt=Q.x,pe=Q.y,Qe=Q.z):(zt=0,pe=0,Qe=0);let De=xt.convert(q.format),yn=xt.convert(q.type),Ot;q.isData3DTexture?(qt.setTexture3D(q,0),Ot=W.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(qt.setTexture2DArray(q,0),Ot=W.TEXTURE_2D_ARRAY):(qt.setTexture2D(q,0),Ot=W.TEXTURE_2D),wt.activeTexture(W.TEXTURE0),wt.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,q.flipY),wt.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),wt.pixelStorei(W.UNPACK_ALIGNMENT,q.unpackAlignment);let dn=wt.getParameter(W.UNPACK_ROW_LENGTH),xe=wt.getParameter(W.UNPACK_IMAGE_HEIGHT),os=wt.getParameter(W.UNPACK_SKIP_PIXELS),pn=wt.getParameter(W.UNPACK_SKIP_ROWS),Pr=wt.getParameter(W.UNPACK_SKIP_IMAGES);wt.pixelStorei(W.UNPACK_ROW_LENGTH,Le.width),wt.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Le.height),wt.pixelStorei(W.UNPACK_SKIP_PIXELS,Gt),wt.pixelStorei(W.UNPACK_SKIP_ROWS,ie),wt.pixelStorei(W.UNPACK_SKIP_IMAGES,de);let Hi=P.isDataArrayTexture||P.isData3DTexture,as=q.isDataArrayTexture||q.isData3DTexture;if(P.isDepthTexture){let ce=Vt.get(P),sn=Vt.get(q),zn=Vt.get(ce.__renderTarget),Ne=Vt.get(sn.__renderTarget);wt.bindFramebuffer(W.READ_FRAMEBUFFER,zn.__webglFramebuffer),wt.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ne.__webglFramebuffer);for(let mn=0;mn<Lt;mn++)Hi&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Vt.get(P).__webglTexture,et,de+mn),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Vt.get(q).__webglTexture,Tt,Qe+mn)),W.blitFramebuffer(Gt,ie,Gt+Pt,ie+At,zt,pe,zt+Pt,pe+At,W.DEPTH_BUFFER_BIT,W.NEAREST);wt.bindFramebuffer(W.READ_FRAMEBUFFER,null),wt.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(et!==0||P.isRenderTargetTexture||Vt.has(P)){let ce=Vt.get(P),sn=Vt.get(q);wt.bindFramebuffer(W.READ_FRAMEBUFFER,D),wt.bindFramebuffer(W.DRAW_FRAMEBUFFER,F);for(let zn=0;zn<Lt;zn++)Hi?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ce.__webglTexture,et,de+zn):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ce.__webglTexture,et),as?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,sn.__webglTexture,Tt,Qe+zn):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,sn.__webglTexture,Tt),et!==0?W.blitFramebuffer(Gt,ie,Gt+Pt,ie+At,zt,pe,zt+Pt,pe+At,W.COLOR_BUFFER_BIT,W.NEAREST):as?W.copyTexSubImage3D(Ot,Tt,zt,pe,Qe+zn,Gt,ie,Pt,At):W.copyTexSubImage2D(Ot,Tt,zt,pe,Gt,ie,Pt,At);wt.bindFramebuffer(W.READ_FRAMEBUFFER,null),wt.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else as?P.isDataTexture||P.isData3DTexture?W.texSubImage3D(Ot,Tt,zt,pe,Qe,Pt,At,Lt,De,yn,Le.data):q.isCompressedArrayTexture?W.compressedTexSubImage3D(Ot,Tt,zt,pe,Qe,Pt,At,Lt,De,Le.data):W.texSubImage3D(Ot,Tt,zt,pe,Qe,Pt,At,Lt,De,yn,Le):P.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,Tt,zt,pe,Pt,At,De,yn,Le.data):P.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,Tt,zt,pe,Le.width,Le.height,De,Le.data):W.texSubImage2D(W.TEXTURE_2D,Tt,zt,pe,Pt,At,De,yn,Le);wt.pixelStorei(W.UNPACK_ROW_LENGTH,dn),wt.pixelStorei(W.UNPACK_IMAGE_HEIGHT,xe),wt.pixelStorei(W.UNPACK_SKIP_PIXELS,os),wt.pixelStorei(W.UNPACK_SKIP_ROWS,pn),wt.pixelStorei(W.UNPACK_SKIP_IMAGES,Pr),Tt===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&W.generateMipmap(Ot),wt.unbindTexture()},this.initRenderTarget=function(P){Vt.get(P).__webglFramebuffer===void 0&&qt.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?qt.setTextureCube(P,0):P.isData3DTexture?qt.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?qt.setTexture2DArray(P,0):qt.setTexture2D(P,0),wt.unbindTexture()},this.resetState=function(){G=0,k=0,tt=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var R0={type:"change"},Jf={type:"start"},P0={type:"end"},bh=new yr,C0=new On,g1=Math.cos(70*Uf.DEG2RAD),bn=new K,ti=2*Math.PI,Ae={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Zf=1e-6,Eh=class extends Ua{constructor(t,e=null){super(t,e),this.state=Ae.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:js.ROTATE,MIDDLE:js.DOLLY,RIGHT:js.PAN},this.touches={ONE:Zs.ROTATE,TWO:Zs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new fi,this._lastTargetPosition=new K,this._quat=new fi().setFromUnitVectors(t.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Eo,this._sphericalDelta=new Eo,this._scale=1,this._panOffset=new K,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new K,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=x1.bind(this),this._onPointerDown=_1.bind(this),this._onPointerUp=y1.bind(this),this._onContextMenu=T1.bind(this),this._onMouseWheel=S1.bind(this),this._onKeyDown=w1.bind(this),this._onTouchStart=b1.bind(this),this._onTouchMove=E1.bind(this),this._onMouseDown=v1.bind(this),this._onMouseMove=M1.bind(this),this._interceptControlDown=A1.bind(this),this._interceptControlUp=R1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ae.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(R0),this.update(),this.state=Ae.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;bn.copy(e).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===Ae.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ti:n>Math.PI&&(n-=ti),s<-Math.PI?s+=ti:s>Math.PI&&(s-=ti),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),e.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(bh.origin.copy(this.object.position),bh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(bh.direction))<g1?this.object.lookAt(this.target):(C0.setFromNormalAndCoplanarPoint(this.object.up,this.target),bh.intersectPlane(C0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Zf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Zf||this._lastTargetPosition.distanceToSquared(this.target)>Zf?(this.dispatchEvent(R0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ti/60*this.autoRotateSpeed*t:ti/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){bn.setFromMatrixColumn(e,0),bn.multiplyScalar(-t),this._panOffset.add(bn)}_panUp(t,e){this.screenSpacePanning===!0?bn.setFromMatrixColumn(e,1):(bn.setFromMatrixColumn(e,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(t),this._panOffset.add(bn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function _1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function x1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function y1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(P0),this.state=Ae.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function v1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ae.DOLLY;break;case js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}break;case js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(Jf)}function M1(i){switch(this.state){case Ae.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ae.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ae.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function S1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ae.NONE||(i.preventDefault(),this.dispatchEvent(Jf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(P0))}function w1(i){this.enabled!==!1&&this._handleKeyDown(i)}function b1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Zs.ROTATE:if(this.enableRotate===!1){this.state=Ae.NONE;break}this._handleTouchStartRotate(i),this.state=Ae.TOUCH_ROTATE;break;case Zs.PAN:if(this.enablePan===!1){this.state=Ae.NONE;break}this._handleTouchStartPan(i),this.state=Ae.TOUCH_PAN;break;default:this.state=Ae.NONE}break;case 2:switch(this.touches.TWO){case Zs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ae.TOUCH_DOLLY_PAN;break;case Zs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ae.TOUCH_DOLLY_ROTATE;break;default:this.state=Ae.NONE}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(Jf)}function E1(i){switch(this._trackPointer(i),this.state){case Ae.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ae.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ae.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ae.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ae.NONE}}function T1(i){this.enabled!==!1&&i.preventDefault()}function A1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function R1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var[C1,P1,Kf]=[2.6,1.7,1.8],Qf=30,I0=Math.min(2,devicePixelRatio),[I1,L1]=[.25,34];function L0(i,t){let e=document.createElement("canvas"),n=e.getContext("webgl2",{antialias:!0,alpha:!0});if(!n)return i.querySelector(".missing").hidden=!1,null;let s=new Mh({canvas:e,context:n});s.setPixelRatio(I0),s.localClippingEnabled=!0,i.append(s.domElement);let r=Sl(i),[o,a]=[new _a,new qn(35,1,.1,50)];a.position.set(-2.7,2.1,5);let l=new Eh(a,s.domElement);l.target.set(0,-.08,0),l.enablePan=!1,l.minDistance=2.5,l.maxDistance=9,l.addEventListener("change",I),o.add(new Na(16777215,1.5));let c=new Da(16777215,2.2);c.position.set(-1,3,2),o.add(c);let f=[new On(new K(0,0,-1),Kf/2+.001),new On(new K(0,0,1),Kf/2+.001)],[h,u,p,m,x]=[1,hs(),null,null,!1],[g,d,y]=[!1,0,1],b=(V,O,H)=>new K(C1*(V/Math.PI-.5),P1*(H/Math.PI-.5),Kf*(.5-O/h)),S={surface:[],curves:[],frame:[]};function E(V,O){for(let H of S[V])o.remove(H),H.geometry?.dispose(),H.material.map?.dispose(),H.material.dispose();S[V]=O,O.forEach(H=>o.add(H)),I()}function A(V,O){let H=new Sa(new pi().setFromPoints(V),O);return H.computeLineDistances(),H}function _(){if(!p)return;let{nodes:V,mu0:O,coarse:H}=p,Z=[];for(let ut=V+1;ut<O.length;ut++)ut%V&&H[ut]&&B(ut-V-1,ut-V,ut-1,ut,O,Z);let $=[T(p),T(p.fine)];$[0].setIndex(Z),$.forEach(ut=>ut.computeVertexNormals());let Y={polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},it=new Ra({vertexColors:!0,side:wi,clippingPlanes:f,...Y}),st=()=>new Qi({color:u.ink,transparent:!0,opacity:.4,clippingPlanes:f}),ot=p.rulings.filter(ut=>ut.length>1);E("surface",[...$.map(ut=>new Si(ut,it.clone())),...ot.map(ut=>A(ut.map(Nt=>b(...Nt)),st()))])}function T({theta0:V,theta:O,mu0:H,kind:Z}){let[$,Y]=[new Float32Array(3*H.length),new Float32Array(3*H.length)],it=[u.stable,u.divergent,u.flutter].map(ot=>new he(ot));for(let ot=0;ot<H.length;ot++){let ut=Number.isNaN(H[ot])?0:H[ot];b(V[ot],Math.max(-Qf*h,Math.min(Qf*h,ut)),O[ot]).toArray($,3*ot),it[Z[ot]].toArray(Y,3*ot)}let st=new pi;return st.setAttribute("position",new Kn($,3)),st.setAttribute("color",new Kn(Y,3)),st}function B(V,O,H,Z,$,Y){for(let it of[[V,O,H],[O,Z,H]]){let st=it.map(ot=>$[ot]);!st.some(Number.isNaN)&&Math.max(...st)>0&&Math.min(...st)<h&&Y.push(...it)}}function v(){if(!m){E("curves",[]);return}let V=()=>new Qi({color:u.ink,clippingPlanes:f}),O=()=>new Qi({color:u.faint,clippingPlanes:f}),H=()=>new Qi({color:u.flutter,clippingPlanes:f}),Z=m.flutter.map(({theta0:$,mu0:Y,theta:it})=>A($.map((st,ot)=>b(st,Y[ot],it[ot])),H()));E("curves",Z.concat(m.curves.flatMap(({theta0:$,mu0:Y,theta:it})=>[A($.map((st,ot)=>b(st,Y[ot],it[ot])),V()),A($.map((st,ot)=>b(st,Y[ot],0)),O())])))}function M(){let V=()=>new Qi({color:u.faint}),O=[[0,0],[1,0],[1,1],[0,1],[0,0]].map(([it,st])=>b(it*Math.PI,st*h,0)),[H,Z]=[new K(0,0,.07),new K(-.07,0,0)],$=[30,60,90,120,150].map(it=>[b(it*Math.PI/180,0,0),H]).concat([.25,.5,.75].map(it=>[b(0,it*h,0),Z]),[45,90,135].map(it=>[b(0,0,it*Math.PI/180),Z])),Y=(it,st,ot,ut)=>it.add(new K(st,ot,ut));E("frame",[A(O,V()),A([b(0,0,0),b(0,0,Math.PI)],V()),...$.map(([it,st])=>A([it,it.clone().add(st)],V())),L("0°",Y(b(0,0,0),.03,-.12,.14)),L("θ₀ = 90°",Y(b(Math.PI/2,0,0),0,-.12,.2)),L("180°",Y(b(Math.PI,0,0),0,-.12,.14)),L(`μ₀ = ${h}`,Y(b(0,h,0),-.22,-.1,0)),L(String(h/2),Y(b(0,h/2,0),-.22,-.06,0)),L("θ = 180°",Y(b(0,0,Math.PI),-.1,.13,0)),L("90°",Y(b(0,0,Math.PI/2),-.2,0,0))])}function L(V,O){let H=document.createElement("canvas");[H.width,H.height]=[256,64];let Z=H.getContext("2d");Z.font="36px system-ui, sans-serif",Z.textAlign="center",Z.textBaseline="middle",Z.fillStyle=u.ink,Z.fillText(V,128,32);let $=new Ma(new So({map:new ba(H),depthTest:!1}));return $.scale.set(.72,.18,1),$.position.copy(O),$}function I(){x||(x=!0,requestAnimationFrame(V=>{x=!1,D(V),s.render(o,a),G()}))}function D(V){let O=g&&d&&V-d>L1;d=g?V:0,O&&y>I1&&F(y/2)}function F(V){V!==y&&(y=V,s.setPixelRatio(y*I0))}l.addEventListener("start",()=>{g=!0}),l.addEventListener("end",()=>{[g,d]=[!1,0],F(1),I()});function G(){let{path:V,point:O,theta:H}=t.get()??{path:[],theta:null};r((Z,$,Y)=>{let it=(Nt,Ht,It)=>{let{x:Zt,y:$t}=b(Nt,Math.min(Ht,Qf*h),It).project(a);return[(.5+.5*Zt)*$,(.5-.5*$t)*Y]},[st,ot]=[new Path2D,new Path2D],ut=null;V.forEach(({theta0:Nt,mu0:Ht,theta:It,jump:Zt})=>{let $t=it(Nt,Ht,It);Zt&&ut&&(ot.moveTo(...ut),ot.lineTo(...$t)),st[ut&&!Zt?"lineTo":"moveTo"](...$t),ut=$t}),Z.lineWidth=2,Z.strokeStyle=u.path,Z.stroke(st),Z.setLineDash([7,5]),Z.strokeStyle=u.jump,Z.stroke(ot),Z.setLineDash([]),H!==null&&(Z.beginPath(),Z.arc(...it(O.theta0,Math.min(O.mu0,h),H),6,0,7),Z.fillStyle=u.panel,Z.fill(),Z.lineWidth=3.5,Z.strokeStyle=u.path,Z.stroke())})}function k(){let[V,O]=[Math.max(200,i.clientWidth),Math.max(200,i.clientHeight)];s.setSize(V,O),a.aspect=V/O,a.fov=V<1.25*O?42:30,a.updateProjectionMatrix(),I()}s.domElement.tabIndex=0,s.domElement.setAttribute("role","img"),s.domElement.setAttribute("aria-label","The equilibrium surface; arrow keys turn it, plus and minus come closer and go away"),s.domElement.addEventListener("keydown",V=>{let H={ArrowLeft:[-.1,0,1],ArrowRight:[.1,0,1],ArrowUp:[0,-.1,1],ArrowDown:[0,.1,1],"+":[0,0,.9],"-":[0,0,1.1]}[V.key];H&&(V.preventDefault(),a.position.applyAxisAngle(new K(0,1,0),H[0]),a.position.y=Math.max(-4,Math.min(6,a.position.y-4*H[1])),a.position.multiplyScalar(H[2]),l.update(),I())});function tt(){M(),_(),v(),G()}return k(),M(),{draw:G,show:V=>{p=V,_()},hide:()=>{[p,m]=[null,null],E("surface",[]),v()},curves:V=>{m=V,v()},reach:V=>{h=V,tt()},resize:k,recolour:()=>{u=hs(),tt()}}}var D1=9313225746154785e-25,N1=4,U1=.3,F1=.1,O1=2**-14,D0={theta0:.035,mu0:.02,kappa:.002,alpha:.05,sigma:.02,beta:.1},B1=200;function k1(i,t,e){return e>=1?{...t}:Object.fromEntries(Object.keys(t).map(n=>[n,i[n]+e*(t[n]-i[n])]))}function U0(i,t,e=0){if(t===0)return[[]];let n=[];for(let s=e;s<=i-t;s++)n.push(...U0(i,t-1,s+1).map(r=>[s,...r]));return n}function z1(i,t){let e=i.length>t.length,[n,s]=e?[t,i]:[i,t],r=u=>Math.max(0,...u.map((p,m)=>Math.abs(s[p]-n[m]))),o=U0(s.length,n.length).map(u=>({ranks:u,moved:r(u)})).sort((u,p)=>u.moved-p.moved),[a,l]=o,c=Math.min(...[i,t].flatMap(u=>u.slice(1).map((p,m)=>p-u[m]))),f=l?l.moved>N1*a.moved:a.moved<U1*c;return{pairs:a.ranks.map((u,p)=>e?[u,p]:[p,u]),sure:f&&a.moved<F1}}function F0(i,t){return i.filter(({stability:n})=>n!=="divergent").sort((n,s)=>Math.abs(n.theta-t)-Math.abs(s.theta-t))[0]??null}function td(i,t,e,n){let s=({states:g})=>g.map(d=>d.theta),r=Math.max(...Object.keys(D0).map(g=>Math.abs(e[g]-t[g])/D0[g])),o=1/Math.max(1,Math.min(B1,Math.ceil(r))),a=O1/Math.max(1,r),l=Math.min(D1,a),c=[],f=o*2**-12,[h,u,p,m,x]=[0,o,i(t),n,!1];if(p.status!=="ok"||m===null)return N0(i,e,m,c);for(;h<1;){let g=h+u>=1?1:h+u,d=k1(t,e,g),y=i(d);if(y.status!=="ok"){if(x||=u<=f,x&&g===1)return{theta:m,samples:c,decided:!1};u=x?3*u:u/2;continue}let{pairs:b,sure:S}=z1(s(p),s(y));if(!S&&!x&&u>l){u/=2;continue}let E=V1(p.states,m),A=b.find(([T])=>T===E);if(!A&&!x&&u>a){u/=2;continue}let _=A?y.states[A[1]]:F0(y.states,m);if(c.push({point:d,theta:_?.theta??null,jump:!A}),!_)return N0(i,e,null,c);[h,p,m,u,x]=[g,y,_.theta,Math.min(2*u,o),!1]}return{theta:m,samples:c,decided:!0}}function V1(i,t){let e=0;return i.forEach((n,s)=>{Math.abs(n.theta-t)<Math.abs(i[e].theta-t)&&(e=s)}),e}function N0(i,t,e,n){let{status:s,states:r}=i(t),o=s==="ok"?F0(r,e??t.theta0):null;return o&&n.push({point:{...t},theta:o.theta,jump:!0}),{theta:o?o.theta:e,samples:n,decided:s==="ok"}}var G1=3e3,O0=["theta0","mu0"];function B0({equilibria:i,NAMES:t}){let e=h=>i(h,{contact:!0}),n=[],s=null,r=(...h)=>n.forEach(u=>u(s,new Set(h)));function o(h){return{contact:e(h),liftoff:i(h,{contact:!1})}}function a(h,u=null){let p=o(h),{theta:m,decided:x}=td(e,h,h,null),g=p.contact.states.filter(({stability:y})=>y!=="divergent"),d=u===null?m:g.map(y=>y.theta).sort((y,b)=>Math.abs(y-u)-Math.abs(b-u))[0]??m;s={point:{...h},anchor:{...h},theta:d,decided:x,found:p,path:d===null?[]:[{theta0:h.theta0,mu0:h.mu0,theta:d,jump:!1}],jumps:0,last:null},r("place","point","family")}function l(h,u=s){let p={...s.point,...h},m=td(e,u.anchor,p,u.theta),x=m.samples.map(({point:S,theta:E,jump:A})=>({theta0:S.theta0,mu0:S.mu0,theta:E,jump:A,point:S})),g=x.filter(S=>S.jump),d=t.some(S=>!["theta0","mu0"].includes(S)&&p[S]!==s.point[S]),y=m.decided?p:m.samples.length?m.samples.at(-1).point:u.anchor,b=x.length&&g.length?c(u,x,t.filter(S=>p[S]!==u.anchor[S])):null;s={point:p,anchor:{...y},theta:m.theta,decided:m.decided,found:o(p),path:[...u.path,...x.filter(({theta:S})=>S!==null).map(({point:S,...E})=>E)].slice(-G1),jumps:u.jumps+g.length,last:b??(g.length?null:u.last)},r("point",...d?["family"]:[],...g.length?["jump"]:[])}function c(h,u,p){let m=u.findLastIndex(d=>d.jump),x=p.every(d=>O0.includes(d))?O0:p,g=Object.fromEntries(x.map(d=>[d,u[m].point[d]]));return{from:m>0?u[m-1].theta:h.theta,to:u[m].theta,fold:g}}function f(){s={...s,path:s.path.slice(-1),jumps:0,last:null},r("point")}return{get:()=>s,listen:h=>n.push(h),place:a,move:l,forget:f}}function tr({found:i,theta:t}){let{states:e}=i.contact;return t===null||!e.length?null:e.reduce((n,s)=>Math.abs(s.theta-t)<Math.abs(n.theta-t)?s:n)}var le=Fd(X0(),1);var dd=le.EigenvalueDecomposition;var Tr=le.Matrix;var rP=le.default.Matrix?le.default.Matrix:le.Matrix;var pd=le.solve;var AE=1e-12;function q0(i,t,e,n){if(![t,e].flat(2).every(Number.isFinite))return{word:"marginal",rate:NaN};if(!t.flat().some(Boolean))return{word:n,rate:n==="stable"?0:RE(i,e)};let{rate:s,swings:r,size:o}=CE(i,t,e);return{word:Math.abs(s)>AE*o?s<0?"stable":r?"flutter":"divergent":"marginal",rate:s}}function RE(i,t){let{realEigenvalues:e,imaginaryEigenvalues:n}=new dd(pd(new Tr(i),new Tr(t)));return Math.max(...e.map((s,r)=>Math.sqrt((Math.hypot(s,n[r])-s)/2)))}function CE(i,t,e){let n=i.length,[s,r]=[t,e].map(h=>pd(new Tr(i),new Tr(h)).mul(-1)),o=Tr.zeros(2*n,2*n);o.setSubMatrix(Tr.eye(n),0,n).setSubMatrix(r,n,0).setSubMatrix(s,n,n);let{realEigenvalues:a,imaginaryEigenvalues:l}=new dd(o),c=Math.max(...a),f=Math.max(...a.map((h,u)=>Math.hypot(h,l[u])));return{rate:c,swings:Math.abs(l[a.indexOf(c)])>1e-9*f,size:f}}var Y0={stable:"●",divergent:"▲",flutter:"≈",marginal:"○"},PE=[[1,0],[0,1]];function ja(i,{mu0:t,alpha:e,sigma:n,beta:s},{theta:r,L:o,y:a,stability:l},c,{V:f,d:h}){let u=c?1:0,p=[[i.damping(a,t,f,h,u),0],[0,0]];return q0(PE,p,i.stiffness(Math.cos(r),Math.sin(r),o,t,e,n,s,u),l)}var $0=["x","y","L"],IE=["spring S","other springs","normal n","friction μ₀n"],LE=(i,t)=>["","regime","stability","θ in °",...$0.map(e=>e+i),"growth","undamped (27)","error bound",...IE.map(e=>e+t)],DE={stable:"stable: pushed a little, the mass comes back",divergent:"unstable (divergence): pushed a little, the mass leaves without swinging",flutter:"unstable (flutter): pushed a little, the mass swings more and more",marginal:"marginal: nothing grows or dies out that double precision could see"};function j0({contact:i,liftoff:t}){return[["in contact",i],["in lift-off",t]].flatMap(([n,{status:s}])=>s==="uncertain"?`Undecided ${n}: double precision can't tell how many states there are here, or of which kind. The rows are a best guess; the Python package decides.`:s==="out_of_range"?`Undecided ${n}: numbers of this size are beyond double precision.`:[]).join(" ")}function Z0(i,t,e,n,s={length:[1,""],force:[1,""]}){let[[r,o],[a,l]]=[s.length,s.force],c=LE(o&&` in ${o}`,l&&` in ${l}`);i.innerHTML=`<thead><tr>${c.map(u=>`<th scope="col">${u}</th>`).join("")}</tr></thead><tbody></tbody>`;let f=i.tBodies[0];function h(u,p,m,x){let g=el(e,m,u,p==="contact"),{word:d,rate:y}=ja(e,m,u,p==="contact",n),b=[He(Je(u.theta),8),...$0.map(E=>He(r*u[E],7)),He(y,2),u.stability,He(u.error,2),...[Math.hypot(...g.spring),Math.hypot(...g.ties),g.normal[1],g.friction[0]].map(E=>He(a*E,5))],S=document.createElement("tr");return S.className=`${d}${x?" chosen":""}`,x&&S.setAttribute("aria-current","true"),S.innerHTML=`<td>${x?"<b title='the mass is here'>➤<span class='hidden'> the mass is here</span></b>":""}</td><td>${p}</td>
      <td title="${DE[d]}"><i aria-hidden="true">${Y0[d]}</i> ${d}</td>${b.map(E=>`<td>${E}</td>`).join("")}`,S}return()=>{let u=t.get(),[p,{contact:m,liftoff:x}]=[tr(u),u.found];f.replaceChildren(...m.states.map(g=>h(g,"contact",u.point,g===p&&u.decided)),...x.states.map(g=>h(g,"lift-off",u.point,!1)))}}var NE={theta0:"θ₀",mu0:"μ₀",kappa:"κ",alpha:"α",sigma:"σ",beta:"β"};function UE(i){return Object.entries(i).map(([t,e])=>`${NE[t]} = ${t==="theta0"?`${He(Je(e),4)}°`:He(e,4)}`).join(", ")}function J0({point:i,theta:t,decided:e,found:n,last:s,jumps:r},o,a,[l,c]=[1,""]){let f=tr({found:n,theta:t});if(!e)return`Undecided here: double precision can't tell the states apart, as on a fold.${t===null?"":` The mass stays at its last decided state, θ = ${He(Je(t),4)}°.`}`;if(!f)return"No state in contact with the belt: see the motion below.";let h=Math.abs(f.theta-i.theta0)<.35?"hardly moved":"swept along by the belt",{word:u,rate:p}=ja(o,i,f,!0,a),m=f.stability==="stable"?`, at the rate ${He(p,2)}: without friction's own damping nothing would grow`:"",x=u==="flutter"?`; it flutters, so the motion below swings up${m}`:"",g=s?` It jumped from θ = ${He(Je(s.from),4)}° to ${He(Je(s.to),4)}° when the point crossed the fold at ${UE(s.fold)}.`:"",d=r>1?` ${r} jumps on this path.`:"";return`${n.contact.count} ${n.contact.count===1?"state":"states"} in contact. The mass is ${h}: θ = ${He(Je(f.theta),4)}°, x = ${He(l*f.x,4)}${c&&` ${c}`}${x}.${g}${d}`}var FE=14,OE=.012,K0={across:[[30,.5],[60,.5]],back:[[60,.5],[30,.5]],home:[[30,.5],[30,.05],[60,.05],[30,.5]],around:[[30,.5],[30,.1],[90,.1],[90,.5],[60,.5]]},BE=([i,t],[e,n])=>Math.hypot(e-i,(n-t)/OE);function Q0(i,t,e,n){let{theta0:s,mu0:r}=i.get().point,o=[[Je(s),r],...t],[a,l,c,f]=[1,0,performance.now(),!0];function h(u){if(!f)return;let[p,m]=[o[a-1],o[a]];l=e?1:Math.min(1,l+FE*Math.min(u-c,100)/1e3/Math.max(BE(p,m),1e-9)),c=u;let[x,g]=[0,1].map(d=>l===1?m[d]:p[d]+l*(m[d]-p[d]));i.move({theta0:$i(x),mu0:g}),l===1&&([a,l]=[a+1,0]),a<o.length?requestAnimationFrame(h):(f=!1,n())}return requestAnimationFrame(h),()=>{f=!1,n()}}var cn=i=>document.getElementById(i),t_=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,kE=450,zE=[["theta0","θ₀","inclination of the spring",.5,179.5],["mu0","μ₀","friction coefficient",0,1],["kappa","κ","preload",.001,.05],["alpha","α","stiffness along the belt",0,1],["sigma","σ","stiffness of the inclined spring",.02,1],["beta","β","stiffness across the belt",0,3]].map(([i,t,e,n,s])=>({name:i,symbol:t,meaning:e,low:n,high:s,angle:i==="theta0"}));function VE(i){let t=JSON.parse(cn("data").textContent);window.spragsym=Object.freeze({equilibria:({contact:O=!0,...H})=>i.equilibria(H,{contact:O})});let e=B0(i),n={...t.drive},s=kd(i),r=O=>e.move({theta0:Math.min(Math.PI-1e-4,Math.max(1e-4,O))}),o=$d(cn("mechanism"),{anchor:r,mass:F}),a=Lm(cn("plane"),e),l=L0(cn("space"),e),c=Gd(cn("parameters"),e,zE,i.RANGES,$h(t.units)),f=Z0(cn("states"),e,i.algebra,n,t.units??void 0),h=[["V","speed of the belt"],["d","steepness of the friction law"]].map(([O,H])=>({id:O,symbol:O,meaning:H,value:n[O],range:i.RANGES[O]})),u=Cm(["x","y"],h,t.units??void 0,{beside:$h(t.units),field:O=>GE(i.motion,e.get().point,O),state:()=>{let O=tr(e.get());return O&&[O.x,O.y]},frame:D,rest:()=>{o.roll(0),e.get()&&x(e.get())},begun:O=>{m=null,Object.assign(n,O),I()}});["V","d"].forEach(O=>cn(O).onchange=()=>{let H=u.numbersOf();H&&(Object.assign(n,H),I(),e.get()&&(f(),_(e.get())))});let[p,m]=[1,null];function x(O,H,Z){let $=tr(O),Y=$?{x:H??$.x,y:Z??$.y}:{x:0,y:0};o.draw({...d(O.point),...Y,others:O.found.contact.states.filter(it=>it!==$).map(it=>({...it,word:g(it)})),kind:$?g($):"",forces:$&&H===void 0?el(i.algebra,O.point,$,!0):null,note:$?"at rest on the sliding belt; pale: the other states":"no state in contact"})}let g=O=>ja(i.algebra,e.get().point,O,!0,n).word;function d({theta0:O,alpha:H,beta:Z}){return{to:[{at:[Math.cos(O),Math.sin(O)],angle:O,symbol:"θ₀"}],ties:[H>0,Z>0]}}function y(O){let[H,Z]=[O.last.from,tr(O)],$=m?.at??b(H,O.point),Y=performance.now(),it=m={at:$},st=ot=>{let ut=Math.min(1,(ot-Y)/kE);if(m!==it||u.moving())return;let[Nt,Ht]=[0,1].map(It=>$[It]+(1-(1-ut)**3)*([Z.x,Z.y][It]-$[It]));it.at=[Nt,Ht],ut<1?(x(e.get(),Nt,Ht),requestAnimationFrame(st)):(m=null,x(e.get()))};requestAnimationFrame(st)}function b(O,H){let{theta0:Z,kappa:$,sigma:Y,beta:it}=H,[,st,ot]=i.algebra.state(Math.cos(O),Math.sin(O),Math.cos(Z),Math.sin(Z),$,Y,it,1);return[st,ot]}let S=!1,E=new Set;e.listen((O,H)=>{H.forEach(Z=>E.add(Z)),f(),c(H.has("place")),_(O),S||(S=!0,requestAnimationFrame(()=>{S=!1,T(new Set(E)),E.clear()}))});let A=0;function _(O){cn("status").textContent=j0(O.found),cn("count").textContent=O.found.contact.status==="ok"?`${O.found.contact.count} in contact, ${O.found.liftoff.count} in lift-off`:"undecided",cn("story").textContent=J0(O,i.algebra,n,t.units?.length),clearTimeout(A),A=setTimeout(()=>cn("spoken").textContent=cn("story").textContent,700)}function T(O){let H=e.get(),Z=H.point.mu0<=.999?1:2**Math.ceil(Math.log2(1.05*H.point.mu0));Z!==p&&(p=Z,a.reach(p),l?.reach(p),O.add("family")),O.has("family")&&v(H.point),O.has("jump")&&H.last&&tr(H)&&!t_()&&!u.moving()?y(H):!u.moving()&&!m&&x(H),a.draw(),l?.draw(),u.changed(),I()}let B="";function v({theta0:O,mu0:H,...Z}){let $=JSON.stringify([Z,p]);if($===B)return;B=$;let{contact:Y,liftoff:it}=e.get().found;if([Y,it].some(({status:st})=>st==="out_of_range")){a.show(null),cn("lowest").textContent="",l?.hide(),cn("plane_says").textContent="Not drawn: numbers of this size are beyond double precision.";return}s("curves",Z,p,(st,ot)=>{a.show(st),cn("lowest").textContent=Dm(st),l?.curves(st),cn("plane_says").textContent=ot??""}),l&&s("surface",Z,p,st=>st?l.show(st):l.hide())}let M=()=>Hd({...e.get().point,theta:e.get().theta,...n},["theta0","theta"]),L=0;function I(){clearTimeout(L),L=setTimeout(()=>history.replaceState(null,"",`#${M()}`),250)}function D(O,[H,Z],{contact:$}){let Y=e.get();o.roll(O*n.V),o.draw({...d(Y.point),x:H,y:Z,others:Y.found.contact.states,kind:$?"":"off",note:`in motion, τ = ${O.toFixed(0)}; pale: the states`})}function F(O,H,Z){let $=[Math.max(-1.7,Math.min(2,O)),Math.max(-.1,Math.min(1.4,H))],Y=e.get();o.draw({...d(Y.point),x:$[0],y:$[1],others:Y.found.contact.states,note:"let go, and it moves from here at rest"}),u.hold($,Z)}let G=cn("preset");t.presets.forEach(({name:O},H)=>G.append(new Option(O,H))),G.onchange=()=>{let{point:O,theta:H}=t.presets[Number(G.value)];u.still(),e.place(O,H??null),G.blur()};let k=null;document.querySelectorAll("[data-walk]").forEach(O=>{O.onclick=()=>{k?.(),u.still();let H=K0[O.dataset.walk],Z=["back","home"].includes(O.dataset.walk);Z||e.place({...t.presets[0].point,theta0:$i(H[0][0]),mu0:H[0][1]}),k=Q0(e,H.slice(Z?0:1),t_(),()=>{k=null})}}),cn("plane").addEventListener("pointerdown",()=>k?.()),cn("forget").onclick=()=>e.forget(),cn("link").onclick=()=>Xd(M(),cn("link_says"));function tt(){let O=Wd(location.hash,[...i.NAMES,"theta","V","d"],i.RANGES),{V:H=n.V,d:Z=n.d,theta:$=null,...Y}=O??{};Object.assign(n,{V:H,d:Z}),u.put(n),u.still(),e.place({...t.presets[0].point,...Y},$)}let V=()=>{a.resize(),l?.resize(),u.resize()};new ResizeObserver(V).observe(cn("page")),zd(()=>{a.recolour(),l?.recolour(),u.recolour()}),window.addEventListener("hashchange",tt),tt()}function GE(i,t,e){let{alpha:n,beta:s,sigma:r,mu0:o,kappa:a}=t,l=Math.max(Math.sqrt(Math.max(1,n+r,1+s+r)),.02*o*e.d*Math.max(a,.02));return{...i(t,e),pieces:(c,f,h)=>Math.min(1e3,Math.ceil(f/h*l))}}return y_(HE);})();
