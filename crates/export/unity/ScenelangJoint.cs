using UnityEngine;

namespace Scenelang
{
    /// <summary>How a part moves.</summary>
    public enum ScenelangMotion
    {
        /// <summary>It turns about its axis.</summary>
        Hinge,

        /// <summary>It slides along its axis.</summary>
        Slide
    }

    /// <summary>A part of an object that opens: a door, a drawer, a lid. Its game object is a child of the object's.</summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangJoint : MonoBehaviour
    {
        /// <summary>The object and the part: <c>wardrobe/door</c>.</summary>
        [Tooltip("The object and the part.")]
        public string id;

        /// <summary>How it moves.</summary>
        public ScenelangMotion motion;

        /// <summary>Direction of the axis in the frame of the object, of unit length.</summary>
        [Tooltip("Direction of the axis in the frame of the object.")]
        public Vector3 axis;

        /// <summary>A point of the axis in the frame of the object.</summary>
        [Tooltip("A point of the axis in the frame of the object.")]
        public Vector3 pivot;

        /// <summary>The least opening: degrees of a hinge, metres of a slide; 0 is closed.</summary>
        [Tooltip("Degrees of a hinge, metres of a slide; 0 is closed.")]
        public float min;

        /// <summary>The greatest opening: degrees of a hinge, metres of a slide.</summary>
        [Tooltip("Degrees of a hinge, metres of a slide.")]
        public float max;

        /// <summary>Where it is taken hold of; none where that is not known.</summary>
        [Tooltip("Where it is taken hold of.")]
        public Transform handle;

        // Degrees or metres per second.
        const float FastestTurn = 90f;
        const float FastestSlide = 0.5f;

        // Seconds in which most of the way that is left is covered.
        const float Settle = 0.15f;

        // Degrees and metres within which it has arrived.
        const float NearTurn = 0.2f;
        const float NearSlide = 0.0005f;

        bool driven;
        float target;

        /// <summary>How far it is open now: degrees of a hinge, metres of a slide.</summary>
        public float Opening
        {
            get
            {
                if (motion == ScenelangMotion.Slide) return Vector3.Dot(transform.localPosition, axis);
                Quaternion turn = transform.localRotation;
                Vector3 about = new Vector3(turn.x, turn.y, turn.z);
                float angle = 2f * Mathf.Rad2Deg * Mathf.Atan2(Vector3.Dot(about, axis), turn.w);
                float middle = 0.5f * (min + max);
                return middle + Mathf.DeltaAngle(middle, angle);
            }
        }

        /// <summary>How far it is open now: 0 is closed, 1 is as far as it goes.</summary>
        public float Fraction
        {
            get { return max > 0f ? Opening / max : 0f; }
        }

        /// <summary>Whether it is on its way to where <see cref="Open"/> or <see cref="Close"/> sent it.</summary>
        public bool IsMoving
        {
            get { return driven; }
        }

        /// <summary>
        /// Opens it: 0 is closed, 1 is as far as it goes. In play mode it moves there, pushes what is loose out of its way and
        /// stops at what is not; outside play mode it is there at once.
        /// </summary>
        public void Open(float fraction = 1f)
        {
            float opening = Mathf.Clamp01(fraction) * max;
            if (Application.isPlaying)
            {
                driven = true;
                target = opening;
                return;
            }
            Place(opening);
        }

        /// <summary>Closes it, in the way of <see cref="Open"/>.</summary>
        public void Close()
        {
            Open(0f);
        }

        /// <summary>Leaves it where it is, to move freely.</summary>
        public void Release()
        {
            driven = false;
        }

        /// <summary>Puts it where it is opened so far, in degrees or metres, whatever is in the way.</summary>
        public void Place(float opening)
        {
            if (motion == ScenelangMotion.Slide)
            {
                transform.localPosition = axis * opening;
                transform.localRotation = Quaternion.identity;
                return;
            }
            Quaternion turn = Quaternion.AngleAxis(opening, axis);
            transform.localRotation = turn;
            transform.localPosition = pivot - turn * pivot;
        }

        /// <summary>Gives it a speed of opening against its object for one step: degrees or metres per second.</summary>
        public void Push(float speed)
        {
            Joint joint = GetComponent<Joint>();
            Rigidbody body = GetComponent<Rigidbody>();
            if (joint == null || body == null || joint.connectedBody == null) return;
            Transform frame = transform.parent;
            Vector3 along = frame.TransformDirection(axis);
            Vector3 centre = body.worldCenterOfMass;
            Vector3 linear = joint.connectedBody.GetPointVelocity(centre);
            Vector3 angular = joint.connectedBody.angularVelocity;
            if (motion == ScenelangMotion.Slide)
            {
                linear += along * speed;
            }
            else
            {
                Vector3 turning = along * (speed * Mathf.Deg2Rad);
                angular += turning;
                linear += Vector3.Cross(turning, centre - frame.TransformPoint(pivot));
            }
            body.AddForce(linear - body.GetPointVelocity(centre), ForceMode.VelocityChange);
            body.AddTorque(angular - body.angularVelocity, ForceMode.VelocityChange);
        }

        void FixedUpdate()
        {
            if (!driven) return;
            bool turns = motion == ScenelangMotion.Hinge;
            float left = target - Opening;
            if (Mathf.Abs(left) < (turns ? NearTurn : NearSlide))
            {
                driven = false;
                Push(0f);
                return;
            }
            float fastest = turns ? FastestTurn : FastestSlide;
            Push(Mathf.Clamp(left / Settle, -fastest, fastest));
        }
    }
}
