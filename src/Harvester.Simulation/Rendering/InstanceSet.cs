using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Mesh instances with a tree over their boxes in the world.</summary>
internal sealed class InstanceSet
{
    /// <summary>A box is cheaper to test than a ray is to move into the frame of a mesh.</summary>
    private const int LeafSize = 1;

    private readonly MeshInstance[] _instances;

    public InstanceSet(IEnumerable<MeshInstance> instances)
    {
        MeshInstance[] given = instances.ToArray();
        Hierarchy = new BoundingVolumeHierarchy(Array.ConvertAll(given, instance => instance.Mesh.Bounds.MovedBy(instance.Pose)), LeafSize);
        _instances = Array.ConvertAll(Hierarchy.Order, number => given[number]);
    }

    public BoundingVolumeHierarchy Hierarchy { get; }

    /// <summary>The instances in the tree's order.</summary>
    public ReadOnlySpan<MeshInstance> Instances => _instances;

    /// <summary>Shortens a ray to the nearest triangle of the set, if one is nearer than the limit.</summary>
    /// <returns>Whether the ray was shortened; the handle is then that of the entity hit.</returns>
    public bool Intersect(Ray ray, int ignoredHandle, ref double limit, ref int handle)
    {
        var visitor = new InstanceVisitor(_instances, ray, ignoredHandle);
        Hierarchy.Visit(ray.Origin, ray.Direction, ref limit, ref visitor);
        if (visitor.Hit)
        {
            handle = visitor.Handle;
        }

        return visitor.Hit;
    }

    private struct InstanceVisitor(MeshInstance[] instances, Ray ray, int ignoredHandle) : ILeafVisitor
    {
        public bool Hit { get; private set; }

        public int Handle { get; private set; }

        public void Visit(int first, int count, ref double limit)
        {
            for (int i = first; i < first + count; i++)
            {
                ref readonly MeshInstance instance = ref instances[i];
                if (instance.Handle != 0 && instance.Handle == ignoredHandle)
                {
                    continue;
                }

                var visitor = new TriangleVisitor(
                    instance.Mesh, instance.Pose.ToLocal(ray.Origin), instance.Pose.Axes.ToLocal(ray.Direction));
                instance.Mesh.Hierarchy.Visit(visitor.Origin, visitor.Direction, ref limit, ref visitor);
                if (visitor.Hit)
                {
                    Hit = true;
                    Handle = instance.Handle;
                }
            }
        }
    }

    /// <summary>The test of Möller and Trumbore; both sides of a triangle count, edges included.</summary>
    private struct TriangleVisitor(Mesh mesh, Vector3D origin, Vector3D direction) : ILeafVisitor
    {
        public readonly Vector3D Origin => origin;

        public readonly Vector3D Direction => direction;

        public bool Hit { get; private set; }

        public void Visit(int first, int count, ref double limit)
        {
            ReadOnlySpan<MeshTriangle> triangles = mesh.Triangles.Slice(first, count);
            foreach (ref readonly MeshTriangle triangle in triangles)
            {
                Vector3D ab = triangle.B - triangle.A;
                Vector3D ac = triangle.C - triangle.A;
                Vector3D p = direction.Cross(ac);
                double determinant = ab.Dot(p);
                if (determinant == 0)
                {
                    continue;
                }

                Vector3D fromA = origin - triangle.A;
                double u = fromA.Dot(p) / determinant;
                if (!(u >= 0 && u <= 1))
                {
                    continue;
                }

                Vector3D q = fromA.Cross(ab);
                double v = direction.Dot(q) / determinant;
                double distance = ac.Dot(q) / determinant;
                if (v >= 0 && u + v <= 1 && distance >= 0 && distance < limit)
                {
                    limit = distance;
                    Hit = true;
                }
            }
        }
    }
}
