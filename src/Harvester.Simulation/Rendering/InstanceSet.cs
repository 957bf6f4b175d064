using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Mesh instances with a tree over their boxes in the world.</summary>
internal sealed class InstanceSet
{
    /// <summary>A box is cheaper to test than a ray is to move into the frame of a mesh.</summary>
    private const int LeafSize = 1;

    private readonly MeshInstance[] _instances;
    private HashSet<int>? _handles;
    private RayTree? _rays;

    public InstanceSet(IEnumerable<MeshInstance> instances)
    {
        MeshInstance[] given = instances.ToArray();
        Hierarchy = new BoundingVolumeHierarchy(Array.ConvertAll(given, instance => instance.Mesh.Bounds.MovedBy(instance.Pose)), LeafSize);
        _instances = Array.ConvertAll(Hierarchy.Order, number => given[number]);
    }

    public BoundingVolumeHierarchy Hierarchy { get; }

    /// <summary>The instances in the tree's order.</summary>
    public ReadOnlySpan<MeshInstance> Instances => _instances;

    /// <summary>Those of some handles that instances of the set have.</summary>
    public HashSet<int> HandlesAmong(HashSet<int>? handles)
    {
        if (handles is null)
        {
            return [];
        }

        _handles ??= [.. _instances.Select(instance => instance.Handle)];
        return [.. handles.Where(_handles.Contains)];
    }

    /// <summary>Built on first use: some sets are only drawn. Two threads that ask at once may both build it; results are equal.</summary>
    private RayTree Rays => _rays ??= new RayTree(Hierarchy);

    /// <summary>
    /// Shortens a ray to the nearest triangle of the set, if one is nearer than the limit. Of several instances at the same distance, the
    /// first in the tree's order counts, whatever the order in which they are visited.
    /// </summary>
    /// <returns>Whether the ray was shortened; the hit is then set.</returns>
    public bool Intersect(Ray ray, int ignoredHandle, ref double limit, ref SurfaceHit hit)
    {
        RayTree rays = Rays;
        var visitor = new InstanceVisitor(_instances, rays, ray, ignoredHandle);
        rays.Visit(ray.Origin, ray.Direction, ref limit, ref visitor);
        if (visitor.Nearest < 0)
        {
            return false;
        }

        hit = new SurfaceHit(_instances[visitor.Nearest], visitor.NearestLeaf);
        return true;
    }

    private struct InstanceVisitor(MeshInstance[] instances, RayTree rays, Ray ray, int ignoredHandle) : ILeafVisitor
    {
        /// <summary>The index of the instance hit; -1 if there is none.</summary>
        public int Nearest { get; private set; } = -1;

        /// <summary>The leaf of the tree of its mesh with the triangle hit.</summary>
        public int NearestLeaf { get; private set; }

        public void Visit(int leaf, ref double limit)
        {
            (int first, int count) = rays.Leaves[leaf];
            for (int i = first; i < first + count; i++)
            {
                ref readonly MeshInstance instance = ref instances[i];
                if (instance.Handle != 0 && instance.Handle == ignoredHandle)
                {
                    continue;
                }

                double nearest = i < Nearest ? Math.BitIncrement(limit) : limit;
                var visitor = new BlockVisitor(instance, ray);
                visitor.Visit(ref nearest);
                if (visitor.Hit)
                {
                    limit = nearest;
                    Nearest = i;
                    NearestLeaf = visitor.HitLeaf;
                }
            }
        }
    }

    /// <summary>Visits the triangles of an instance, in the frame of its mesh.</summary>
    private struct BlockVisitor : ILeafVisitor
    {
        private readonly MeshTree _tree;
        private readonly Vector3D _origin;
        private readonly Vector3D _direction;
        private readonly QuadVector _origins;
        private readonly QuadVector _directions;

        public BlockVisitor(in MeshInstance instance, Ray ray)
        {
            _tree = instance.Mesh.Tree;
            _origin = instance.Pose.ToLocal(ray.Origin);
            _direction = instance.Pose.Axes.ToLocal(ray.Direction);
            _origins = QuadVector.Of(_origin);
            _directions = QuadVector.Of(_direction);
        }

        public bool Hit { get; private set; }

        /// <summary>The leaf with the nearest triangle hit so far.</summary>
        public int HitLeaf { get; private set; }

        public void Visit(ref double limit) => _tree.Rays.Visit(_origin, _direction, ref limit, ref this);

        public void Visit(int leaf, ref double limit)
        {
            if (_tree.Blocks[leaf].Shorten(_origins, _directions, ref limit))
            {
                Hit = true;
                HitLeaf = leaf;
            }
        }
    }
}
