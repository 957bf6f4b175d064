using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>The triangles that the renderer draws.</summary>
internal sealed class SolidsPort(SimulatedGame game) : ISolids
{
    /// <summary>The map of the moment that was asked for last: the cameras of a rig ask in turn.</summary>
    private (long State, Pose Frame, VoxelShape Shape, VoxelMap Map)? _last;

    public VoxelMap Fill(VoxelGrid grid, IReadOnlyList<byte> ranks, Func<int, SemanticClass> classOf)
    {
        if (_last is { } last && (last.State, last.Frame, last.Shape) == (game.Picture.State, grid.Frame, grid.Shape))
        {
            return last.Map;
        }

        var map = new VoxelMap(grid, ranks);
        foreach (ref readonly MeshInstance instance in game.World.Scene.Static.Instances)
        {
            Add(map, instance, classOf);
        }

        foreach (MeshInstance instance in game.Picture.Moving)
        {
            Add(map, instance, classOf);
        }

        map.Close();
        _last = (game.Picture.State, grid.Frame, grid.Shape, map);
        return map;
    }

    private static void Add(VoxelMap map, in MeshInstance instance, Func<int, SemanticClass> classOf)
    {
        VoxelGrid grid = map.Grid;
        Bounds around = instance.Mesh.Bounds.MovedBy(instance.Pose);
        if (around.DistanceTo(grid.Frame.Position) > grid.Shape.ReachMetres && !IsAbove(grid, around))
        {
            return;
        }

        // A place in the box depends on a point of the model linearly: p = o + x right + y forward + z up.
        Vector3D origin = grid.PlaceOf(instance.Pose.Position);
        Vector3D right = grid.PlaceOf(instance.Pose.Position + instance.Pose.Axes.Right) - origin;
        Vector3D forward = grid.PlaceOf(instance.Pose.Position + instance.Pose.Axes.Forward) - origin;
        Vector3D up = grid.PlaceOf(instance.Pose.Position + instance.Pose.Axes.Up) - origin;
        var kind = (byte)(instance.Handle == 0 ? SurfacePort.ClassOf(instance.Mesh.Kind) : classOf(instance.Handle));
        foreach (ref readonly MeshTriangle triangle in instance.Mesh.Given)
        {
            map.Add(kind, instance.Handle, PlaceOf(triangle.A), PlaceOf(triangle.B), PlaceOf(triangle.C));
        }

        Vector3D PlaceOf(Vector3D point) => origin + (point.X * right) + (point.Y * forward) + (point.Z * up);
    }

    /// <summary>Whether something high lies above the box: it covers what is in it.</summary>
    private static bool IsAbove(VoxelGrid grid, Bounds around)
    {
        Vector3D place = grid.Frame.Position;
        return around.Min.Z > place.Z && around.DistanceTo(place with { Z = around.Min.Z }) <= grid.Shape.ReachMetres;
    }
}
