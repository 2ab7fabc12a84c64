// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area lights in @react-three/fiber. To see it: `make web-test`, then `python3 -m http.server` in the root of the
// repository and http://localhost:8000/out/web-test/react.html, which esbuild made of this file.

import {Canvas, extend, useFrame, useThree} from '@react-three/fiber';
import {useEffect, useRef} from 'react';
import {createRoot} from 'react-dom/client';
import {RectLight, TubeLight} from 'openltc-three';
import {enableAreaShadows} from 'openltc-three/shadows';

extend({RectLight, TubeLight}); // <rectLight>, <tubeLight>

// Lets the scene's area lights shine and those with castShadow have shadows. (enableAreaLights is for none.)
function AreaShadows({frames}) {
  const scene = useThree(state => state.scene), invalidate = useThree(state => state.invalidate), shadows = useRef(null);
  useEffect(() => {
    shadows.current = enableAreaShadows(scene, {frames});
    invalidate();
    return () => {
      shadows.current.lights.dispose();
      shadows.current = null;
    };
  }, [scene, frames, invalidate]);
  useFrame(() => {
    if (shadows.current?.frame < frames) invalidate(); // until they have converged
  });
  return null;
}

function Lamp({position, children, ...properties}) {
  const light = useRef(null);
  useEffect(() => light.current.lookAt(0, 0, 0), []);
  return <rectLight ref={light} position={position} castShadow {...properties}>{children}</rectLight>;
}

function Room() {
  return <>
    <mesh rotation-x={-Math.PI / 2}>
      <planeGeometry args={[40, 40]} />
      <meshStandardMaterial color={0x888888} roughness={0.3} />
    </mesh>
    <mesh position={[0.6, 0.5, 0]}>
      <sphereGeometry args={[0.5, 96, 48]} />
      <meshStandardMaterial color={0xf0c0a0} roughness={0.4} />
    </mesh>
    <Lamp position={[-1.2, 1.8, 1]} args={[0xffffff, 10, 1.2, 0.6]} />
    <tubeLight position={[0, 0.1, -1]} castShadow args={[0x70a0ff, 20, 2, 0.03]}>
      <mesh rotation-z={Math.PI / 2}>
        <capsuleGeometry args={[0.03, 2, 8, 24]} />
        <meshBasicMaterial color={0x70a0ff} />
      </mesh>
    </tubeLight>
  </>;
}

window.example = new Promise(resolve => {
  createRoot(document.querySelector('main')).render(
      <Canvas frameloop="demand" camera={{position: [0.6, 1.7, 4], fov: 40}}
              onCreated={({gl, scene, camera}) => resolve({canvas: gl.domElement, draw: () => gl.render(scene, camera)})}>
        <AreaShadows frames={64} />
        <Room />
      </Canvas>);
});
