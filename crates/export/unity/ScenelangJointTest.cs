using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Scenelang
{
    /// <summary>
    /// Drives doors, drawers and lids to both ends of their range with the physics engine, without the scene being played, and
    /// puts everything back.
    /// </summary>
    public static class ScenelangJointTest
    {
        // Seconds.
        const float Step = 0.01f;
        const float Longer = 1f;

        // Degrees and metres per second.
        const float TurnSpeed = 90f;
        const float SlideSpeed = 0.3f;

        // Degrees and metres.
        const float TurnTolerance = 1f;
        const float SlideTolerance = 0.005f;

        /// <summary>What is wrong with how a part is connected; null where nothing is.</summary>
        public static string Unconnected(ScenelangJoint part)
        {
            Joint joint = part.GetComponent<Joint>();
            if (joint == null) return "it has no joint";
            ScenelangObject item = part.GetComponentInParent<ScenelangObject>(true);
            if (item == null || part.transform.parent != item.transform) return "it is no child of its object";
            if (joint.connectedBody != item.GetComponent<Rigidbody>()) return "its joint is not connected to " + item.id;
            return null;
        }

        /// <summary>Drives all parts; how many do not reach the ends of their range, or go beyond.</summary>
        public static int Drive(Scene scene, List<ScenelangJoint> parts)
        {
            List<Rigidbody> bodies = new List<Rigidbody>();
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                bodies.AddRange(root.GetComponentsInChildren<Rigidbody>());
            }
            List<bool> held = bodies.ConvertAll(body => body.isKinematic);
            foreach (Rigidbody body in bodies) body.isKinematic = true;
            SimulationMode mode = Physics.simulationMode;
            Physics.simulationMode = SimulationMode.Script;
            int failures = 0;
            try
            {
                foreach (ScenelangJoint part in parts)
                {
                    if (!Reaches(part, part.max)) failures++;
                    if (part.min < 0f && !Reaches(part, part.min)) failures++;
                }
            }
            finally
            {
                Physics.simulationMode = mode;
                for (int i = 0; i < bodies.Count; i++) bodies[i].isKinematic = held[i];
            }
            return failures;
        }

        // Pushes past a limit, where only the joint can stop the part: nothing is in the way of it, and nothing pulls it down.
        static bool Reaches(ScenelangJoint part, float limit)
        {
            Rigidbody body = part.GetComponent<Rigidbody>();
            bool turns = part.motion == ScenelangMotion.Hinge;
            float speed = Mathf.Sign(limit) * (turns ? TurnSpeed : SlideSpeed);
            Vector3 position = part.transform.localPosition;
            Quaternion rotation = part.transform.localRotation;
            bool collides = body.detectCollisions;
            bool falls = body.useGravity;
            part.Place(0f);
            Physics.SyncTransforms();
            body.detectCollisions = false;
            body.useGravity = false;
            body.isKinematic = false;
            float opening;
            try
            {
                int steps = Mathf.CeilToInt((limit / speed + Longer) / Step);
                for (int i = 0; i < steps; i++)
                {
                    part.Push(speed);
                    Physics.Simulate(Step);
                }
                opening = part.Opening;
            }
            finally
            {
                body.isKinematic = true;
                body.useGravity = falls;
                body.detectCollisions = collides;
                part.transform.localPosition = position;
                part.transform.localRotation = rotation;
                Physics.SyncTransforms();
            }
            if (Mathf.Abs(opening - limit) <= (turns ? TurnTolerance : SlideTolerance)) return true;
            string unit = turns ? " degrees" : " m";
            Debug.LogError("scenelang: " + part.id + ": it was driven to " + opening + unit + ", its limit is " + limit + unit, part);
            return false;
        }
    }
}
