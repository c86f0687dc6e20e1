using System.Collections.Generic;
using UnityEngine;
using UnityEngine.AI;

namespace Scenelang
{
    /// <summary>The layers that the game objects of a scene are on.</summary>
    public static class ScenelangLayers
    {
        /// <summary>Floors.</summary>
        public const int Floor = 8;

        /// <summary>Walls.</summary>
        public const int Wall = 9;

        /// <summary>Ceilings.</summary>
        public const int Ceiling = 10;

        /// <summary>Doors and windows in walls.</summary>
        public const int Opening = 11;

        /// <summary>All other objects.</summary>
        public const int Furniture = 12;

        /// <summary>Where doors and drawers are taken hold of.</summary>
        public const int Handle = 13;
    }

    /// <summary>
    /// Bakes where one can walk when the scene starts, from its colliders: on floors, around furniture and walls. Doors in
    /// walls count as open.
    /// </summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangNavMesh : MonoBehaviour
    {
        /// <summary>Half the width that is kept free, in metres.</summary>
        [Tooltip("Half the width that is kept free, in metres.")]
        public float radius = 0.25f;

        /// <summary>The height that is kept free, in metres.</summary>
        [Tooltip("The height that is kept free, in metres.")]
        public float height = 1.8f;

        /// <summary>What is no higher is walked over: rugs, thresholds. In metres.</summary>
        [Tooltip("What is no higher is walked over, in metres.")]
        public float step = 0.05f;

        // The area that nobody walks on, as Unity numbers it.
        const int NotWalkable = 1;

        NavMeshDataInstance baked;

        void OnEnable()
        {
            Bake();
        }

        void OnDisable()
        {
            baked.Remove();
        }

        /// <summary>Bakes again, as the scene stands now. False where there is nothing to walk on.</summary>
        public bool Bake()
        {
            baked.Remove();
            Physics.SyncTransforms();
            const int layers = 1 << ScenelangLayers.Floor | 1 << ScenelangLayers.Wall | 1 << ScenelangLayers.Furniture;
            List<NavMeshBuildSource> found = new List<NavMeshBuildSource>();
            NavMeshBuilder.CollectSources(
                transform, layers, NavMeshCollectGeometry.PhysicsColliders, 0, new List<NavMeshBuildMarkup>(), found);
            List<NavMeshBuildSource> sources = new List<NavMeshBuildSource>();
            Bounds bounds = new Bounds(transform.position, Vector3.zero);
            bool walkable = false;
            foreach (NavMeshBuildSource one in found)
            {
                NavMeshBuildSource source = one;
                Collider solid = source.component as Collider;
                if (solid == null || IsFlat(solid)) continue;
                bool floor = solid.gameObject.layer == ScenelangLayers.Floor;
                walkable |= floor;
                if (!floor) source.area = NotWalkable;
                sources.Add(source);
                bounds.Encapsulate(solid.bounds);
            }
            if (!walkable) return false;
            NavMeshBuildSettings settings = NavMesh.GetSettingsByID(0);
            settings.agentRadius = radius;
            settings.agentHeight = height;
            settings.agentClimb = step;
            settings.overrideVoxelSize = true;
            // Cells of a quarter of the radius, as fine as Unity suggests for narrow passages.
            settings.voxelSize = radius / 4f;
            bounds.Expand(1f);
            Bounds local = new Bounds(bounds.center - transform.position, bounds.size);
            NavMeshData data = NavMeshBuilder.BuildNavMeshData(
                settings, sources, local, transform.position, Quaternion.identity);
            if (data == null) return false;
            baked = NavMesh.AddNavMeshData(data);
            return baked.valid;
        }

        // What lies on the floor and is no higher than a step.
        bool IsFlat(Collider solid)
        {
            ScenelangObject item = solid.GetComponentInParent<ScenelangObject>();
            return item != null && item.boundsMax.y - item.boundsMin.y < step;
        }

        /// <summary>Points that one can stand on beside an object, not behind a wall: its front first.</summary>
        public List<Vector3> Beside(ScenelangObject item)
        {
            List<Vector3> spots = new List<Vector3>();
            Collider[] solids = item.Solids;
            if (solids.Length == 0) return spots;
            Bounds bounds = solids[0].bounds;
            foreach (Collider solid in solids) bounds.Encapsulate(solid.bounds);
            Vector3 front = item.transform.forward;
            Vector3 right = item.transform.right;
            foreach (Vector3 way in new[] { front, right, -right, -front })
            {
                Vector3 level = new Vector3(way.x, 0f, way.z);
                if (level.magnitude < 0.1f) continue;
                level = level.normalized;
                // As far as the box reaches in this direction.
                float reach = Mathf.Abs(level.x) * bounds.extents.x + Mathf.Abs(level.z) * bounds.extents.z;
                Vector3 spot = bounds.center + level * (reach + radius + 0.05f);
                if (Physics.Linecast(bounds.center, spot, 1 << ScenelangLayers.Wall)) continue;
                // What stands, hangs or lies on something is reached from the floor below it.
                RaycastHit below;
                if (!Physics.Raycast(spot, Vector3.down, out below, Mathf.Infinity, 1 << ScenelangLayers.Floor)) continue;
                NavMeshHit hit;
                if (!NavMesh.SamplePosition(below.point, out hit, 2f * radius, NavMesh.AllAreas)) continue;
                Vector3 above = new Vector3(hit.position.x, spot.y, hit.position.z);
                if (!Physics.Linecast(spot, above, 1 << ScenelangLayers.Wall)) spots.Add(hit.position);
            }
            return spots;
        }
    }
}
