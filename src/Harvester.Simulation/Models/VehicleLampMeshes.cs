using System.Collections.Concurrent;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The light of a vehicle's lamps, as meshes around their glasses; each is built when it is first needed.</summary>
public sealed class VehicleLampMeshes
{
    private readonly IReadOnlyList<VehicleLamp> _lamps;
    private readonly ConcurrentDictionary<VehicleLights, Mesh?> _meshes = new();

    internal VehicleLampMeshes(IReadOnlyList<VehicleLamp> lamps) => _lamps = lamps;

    /// <summary>The lamps that shine; null if none does.</summary>
    public Mesh? Of(VehicleLights lights) => _meshes.GetOrAdd(lights, Build);

    private Mesh? Build(VehicleLights lights)
    {
        var glow = new Vector3D(VehicleLampLayout.Glow, VehicleLampLayout.Glow, VehicleLampLayout.Glow);
        var builder = new MeshBuilder();
        VehicleLamp[] lit = [.. _lamps.Where(lamp => ColourOf(lamp.Kind, lights) is not null)];
        foreach (VehicleLamp lamp in lit)
        {
            builder.AddBox(lamp.Min - glow, lamp.Max + glow, ColourOf(lamp.Kind, lights)!.Value, Surface.Lamp);
        }

        return lit.Length == 0 ? null : builder.Build();
    }

    private static Rgb? ColourOf(LampKind kind, VehicleLights lights) =>
        kind switch
        {
            LampKind.Head => lights.Head ? VehiclePaint.HeadLight : null,
            LampKind.Tail => lights.Brake ? VehiclePaint.BrakeLight
            : lights.Head ? VehiclePaint.TailLight
            : null,
            LampKind.HighBrake => lights.Brake ? VehiclePaint.BrakeLight : null,
            LampKind.Left => lights.Left ? VehiclePaint.IndicatorLight : null,
            _ => lights.Right ? VehiclePaint.IndicatorLight : null,
        };
}
