using GTA.Hosting;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>An entity of the test game.</summary>
internal sealed class GameEntity
{
    public required PoolKind Pool { get; init; }

    public required int Model { get; init; }

    public required Pose Pose { get; set; }

    public Vector3D Velocity { get; set; }

    public Vector3D ModelMin { get; init; } = new(-1, -2, -0.5);

    public Vector3D ModelMax { get; init; } = new(1, 2, 1);

    public int VehicleClass { get; init; }

    public bool TyresCanBurst { get; set; } = true;

    public bool WheelsCanBreak { get; set; } = true;

    public bool IsDamagedVisibly { get; set; } = true;

    public (int Primary, int Secondary) Colours { get; set; }

    public string Plate { get; set; } = string.Empty;

    public bool IsOnGround { get; set; }
}
