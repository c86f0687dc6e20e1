// As much of Unity's API as the scripts of an exported project use, with the names and signatures of Unity's manual for 2022.3
// and 6000.0: the compiler checks the scripts against it. Vectors, turns and local poses compute, by Unity's left-handed
// conventions, so that a test can open doors; nothing else does anything.

using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public class Object
    {
        public string name { get; set; }
        public static T FindAnyObjectByType<T>() where T : Object { return null; }
        public static bool operator ==(Object a, Object b) { return ReferenceEquals(a, b); }
        public static bool operator !=(Object a, Object b) { return !ReferenceEquals(a, b); }
        public override bool Equals(object other) { return ReferenceEquals(this, other); }
        public override int GetHashCode() { return 0; }
    }

    public class Component : Object
    {
        Transform own;
        public Transform transform { get { return own = own ?? new Transform(); } }
        public GameObject gameObject { get { return null; } }
        public T GetComponent<T>() { return default(T); }
        public T GetComponentInParent<T>() { return default(T); }
        public T GetComponentInParent<T>(bool includeInactive) { return default(T); }
        public T GetComponentInChildren<T>(bool includeInactive) { return default(T); }
        public T[] GetComponentsInChildren<T>() { return null; }
        public T[] GetComponentsInChildren<T>(bool includeInactive) { return null; }
    }

    public class Behaviour : Component { }
    public class MonoBehaviour : Behaviour { }
    public class ScriptableObject : Object { }
    public class TextAsset : Object { public string text { get { return null; } } }
    public static class JsonUtility { public static T FromJson<T>(string json) { return default(T); } }

    public sealed class GameObject : Object
    {
        public int layer { get; set; }
        public T GetComponentInChildren<T>(bool includeInactive) { return default(T); }
        public T[] GetComponentsInChildren<T>() { return null; }
        public T[] GetComponentsInChildren<T>(bool includeInactive) { return null; }
    }

    public class Transform : Component
    {
        public Transform parent { get; set; }
        public Vector3 position { get; set; }
        public Vector3 localPosition { get; set; }
        public Quaternion localRotation { get; set; }
        public Vector3 forward { get; set; }
        public Vector3 right { get; set; }
        public Vector3 TransformPoint(Vector3 position) { return position; }
        public Vector3 TransformDirection(Vector3 direction) { return direction; }
    }

    public struct Vector2 { public float x, y; }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 zero { get { return default(Vector3); } }
        public static Vector3 down { get { return default(Vector3); } }
        public static Vector3 positiveInfinity { get { return default(Vector3); } }
        public static Vector3 negativeInfinity { get { return default(Vector3); } }
        public float magnitude { get { return 0; } }
        public Vector3 normalized { get { return this; } }
        public static float Dot(Vector3 lhs, Vector3 rhs) { return lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z; }
        public static Vector3 Cross(Vector3 lhs, Vector3 rhs)
        {
            return new Vector3(
                lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);
        }
        public static Vector3 Min(Vector3 lhs, Vector3 rhs) { return lhs; }
        public static Vector3 Max(Vector3 lhs, Vector3 rhs) { return lhs; }
        public static float Distance(Vector3 a, Vector3 b) { return (float)Math.Sqrt(Dot(a - b, a - b)); }
        public static Vector3 operator +(Vector3 a, Vector3 b) { return new Vector3(a.x + b.x, a.y + b.y, a.z + b.z); }
        public static Vector3 operator -(Vector3 a, Vector3 b) { return new Vector3(a.x - b.x, a.y - b.y, a.z - b.z); }
        public static Vector3 operator -(Vector3 a) { return new Vector3(-a.x, -a.y, -a.z); }
        public static Vector3 operator *(Vector3 a, float d) { return new Vector3(a.x * d, a.y * d, a.z * d); }
        public static Vector3 operator *(float d, Vector3 a) { return a * d; }
    }

    public struct Quaternion
    {
        public float x, y, z, w;
        public static Quaternion identity { get { return AngleAxis(0, default(Vector3)); } }
        public static Quaternion AngleAxis(float angle, Vector3 axis)
        {
            double half = angle * Mathf.Deg2Rad / 2;
            Vector3 v = axis * (float)Math.Sin(half);
            return new Quaternion { x = v.x, y = v.y, z = v.z, w = (float)Math.Cos(half) };
        }
        public static Vector3 operator *(Quaternion rotation, Vector3 point)
        {
            Vector3 v = new Vector3(rotation.x, rotation.y, rotation.z);
            Vector3 across = Vector3.Cross(v, point) * 2;
            return point + across * rotation.w + Vector3.Cross(v, across);
        }
    }

    public struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size) { this.center = center; this.size = size; extents = size; }
        public Vector3 center { get; set; }
        public Vector3 size { get; set; }
        public Vector3 extents { get; set; }
        public void Encapsulate(Bounds bounds) { }
        public void Expand(float amount) { }
    }

    public struct Color
    {
        public static Color green { get { return default(Color); } }
        public static Color red { get { return default(Color); } }
        public static Color yellow { get { return default(Color); } }
    }

    public static class Mathf
    {
        public const float Deg2Rad = 0.0174532924F;
        public const float Rad2Deg = 57.29578F;
        public const float Infinity = float.PositiveInfinity;
        public static float Abs(float f) { return Math.Abs(f); }
        public static float Atan2(float y, float x) { return (float)Math.Atan2(y, x); }
        public static int CeilToInt(float f) { return 0; }
        public static float Clamp(float value, float min, float max) { return value; }
        public static float Clamp01(float value) { return Math.Min(Math.Max(value, 0), 1); }
        public static float DeltaAngle(float current, float target)
        {
            float by = (target - current) % 360;
            return by > 180 ? by - 360 : by <= -180 ? by + 360 : by;
        }
        public static float Min(float a, float b) { return a; }
        public static float Sign(float f) { return f; }
    }

    public static class Application { public static bool isPlaying { get { return false; } } }

    public static class Debug
    {
        public static void Log(object message) { }
        public static void LogError(object message, Object context) { }
    }

    public sealed class Mesh : Object
    {
        public int subMeshCount { get { return 0; } }
        public void GetVertices(List<Vector3> vertices) { }
    }

    public sealed class MeshFilter : Component { public Mesh sharedMesh { get; set; } }
    public sealed class Material : Object { }
    public class Renderer : Component { public Material[] sharedMaterials { get; set; } }
    public sealed class MeshRenderer : Renderer { }

    public class Collider : Component
    {
        public bool isTrigger { get; set; }
        public Bounds bounds { get { return default(Bounds); } }
        public Vector3 ClosestPoint(Vector3 position) { return position; }
    }

    public enum ForceMode { Force, Acceleration, Impulse, VelocityChange }

    public sealed class Rigidbody : Component
    {
        public bool isKinematic { get; set; }
        public bool useGravity { get; set; }
        public bool detectCollisions { get; set; }
        public Vector3 angularVelocity { get; set; }
        public Vector3 worldCenterOfMass { get { return default(Vector3); } }
        public Vector3 GetPointVelocity(Vector3 worldPoint) { return worldPoint; }
        public void AddForce(Vector3 force, ForceMode mode) { }
        public void AddTorque(Vector3 torque, ForceMode mode) { }
    }

    public class Joint : Component { public Rigidbody connectedBody { get; set; } }

    public struct RaycastHit { public Vector3 point { get; set; } }

    public enum SimulationMode { FixedUpdate, Update, Script }

    public static class Physics
    {
        public static SimulationMode simulationMode { get; set; }
        public static void Simulate(float step) { }
        public static void SyncTransforms() { }
        public static void IgnoreCollision(Collider collider1, Collider collider2) { }
        public static bool Linecast(Vector3 start, Vector3 end, int layerMask) { return false; }
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask)
        {
            hitInfo = default(RaycastHit);
            return false;
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class DisallowMultipleComponent : Attribute { }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string tooltip) { } }

    public struct Rect { }
    public static class GUI { public static Color color { get; set; } }
    public sealed class GUIContent { public GUIContent(string text, string tooltip) { } }
    public sealed class GUIStyle { }
    public sealed class GUILayoutOption { }

    public static class GUILayout
    {
        public static GUILayoutOption Width(float width) { return null; }
        public static void Label(string text, params GUILayoutOption[] options) { }
        public static bool Button(GUIContent content, GUIStyle style, params GUILayoutOption[] options) { return false; }
        public static bool Toggle(bool value, string text, GUIStyle style, params GUILayoutOption[] options) { return value; }
    }
}

namespace UnityEngine.AI
{
    public enum NavMeshPathStatus { PathComplete, PathPartial, PathInvalid }
    public enum NavMeshCollectGeometry { RenderMeshes, PhysicsColliders }
    public struct NavMeshBuildMarkup { }
    public sealed class NavMeshData : Object { }

    public sealed class NavMeshPath
    {
        public Vector3[] corners { get { return null; } }
        public NavMeshPathStatus status { get { return NavMeshPathStatus.PathInvalid; } }
        public void ClearCorners() { }
    }

    public struct NavMeshHit { public Vector3 position { get; set; } }

    public struct NavMeshDataInstance
    {
        public bool valid { get { return false; } }
        public void Remove() { }
    }

    public struct NavMeshBuildSource
    {
        public int area { get; set; }
        public Component component { get; set; }
    }

    public struct NavMeshBuildSettings
    {
        public float agentRadius { get; set; }
        public float agentHeight { get; set; }
        public float agentClimb { get; set; }
        public bool overrideVoxelSize { get; set; }
        public float voxelSize { get; set; }
    }

    public static class NavMesh
    {
        public const int AllAreas = -1;
        public static NavMeshBuildSettings GetSettingsByID(int agentTypeID) { return default(NavMeshBuildSettings); }
        public static NavMeshDataInstance AddNavMeshData(NavMeshData navMeshData) { return default(NavMeshDataInstance); }
        public static bool CalculatePath(Vector3 sourcePosition, Vector3 targetPosition, int areaMask, NavMeshPath path)
        {
            return false;
        }
        public static bool SamplePosition(Vector3 sourcePosition, out NavMeshHit hit, float maxDistance, int areaMask)
        {
            hit = default(NavMeshHit);
            return false;
        }
    }

    public static class NavMeshBuilder
    {
        public static void CollectSources(
            Transform root, int includedLayerMask, NavMeshCollectGeometry geometry, int defaultArea,
            List<NavMeshBuildMarkup> markups, List<NavMeshBuildSource> results) { }
        public static NavMeshData BuildNavMeshData(
            NavMeshBuildSettings buildSettings, List<NavMeshBuildSource> sources, Bounds localBounds, Vector3 position,
            Quaternion rotation) { return null; }
    }
}

namespace UnityEngine.SceneManagement
{
    public struct Scene
    {
        public string name { get { return null; } }
        public string path { get { return null; } }
        public GameObject[] GetRootGameObjects() { return null; }
    }

    public static class SceneManager { public static Scene GetActiveScene() { return default(Scene); } }
}
