using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Mod.Tests.Games;

/// <summary>An entity of the test game.</summary>
internal sealed class GameEntity
{
    public required PoolKind Pool { get; init; }

    /// <summary>The model's name in lower case.</summary>
    public required string Name { get; init; }

    /// <summary>The model's hash where the name does not give it.</summary>
    public int? Hash { get; init; }

    public int Model => Hash ?? ModelHash.Of(Name);

    public required Pose Pose { get; set; }

    /// <summary>The matrix' vectors where they are not the pose's axes.</summary>
    public (Vector3D Right, Vector3D Forward, Vector3D Up)? Matrix { get; init; }

    public Vector3D Velocity { get; set; }

    public Vector3D ModelMin { get; init; } = new(-1, -2, -0.5);

    public Vector3D ModelMax { get; init; } = new(1, 2, 1);

    /// <summary>Number of the game's class of vehicles; 1 is sedans.</summary>
    public int VehicleClass { get; init; } = 1;

    public bool IsInvincible { get; set; }

    /// <summary>How often it was repaired.</summary>
    public int Repairs { get; set; }

    public bool EngineCanDegrade { get; set; } = true;

    public bool PetrolTankCanBeDamaged { get; set; } = true;

    public bool TyresCanBurst { get; set; } = true;

    public bool WheelsCanBreak { get; set; } = true;

    public bool IsDamagedVisibly { get; set; } = true;

    public (int Primary, int Secondary) Colours { get; set; }

    public string Plate { get; set; } = string.Empty;

    public bool IsOnGround { get; set; }

    /// <summary>Metres from its origin down to the ground.</summary>
    public double HeightAboveGround { get; init; }

    /// <summary>Handle of the vehicle in which a person sits; 0 if there is none.</summary>
    public int Vehicle { get; init; }

    /// <summary>Handle of the trailer that a vehicle pulls; 0 if there is none.</summary>
    public int Trailer { get; set; }

    /// <summary>Handle of the entity to which it is attached; 0 if there is none.</summary>
    public int AttachedTo { get; init; }

    /// <summary>Whether a script has hidden it.</summary>
    public bool IsHidden { get; set; }

    public bool IsFrozen { get; set; }

    /// <summary>The shape that rays hit; null for its box.</summary>
    public Mesh? Shape { get; init; }

    /// <summary>The joints of a person, in the world; null if its model has not the bones of people.</summary>
    public Skeleton? Skeleton { get; set; }

    /// <summary>Bones by number, in the model's frame: traffic_light_0 and on.</summary>
    public IReadOnlyList<Vector3D> Bones { get; init; } = [];
}
