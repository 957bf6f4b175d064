namespace GTA.Hosting;

/// <summary>The game's pools of entities.</summary>
internal enum PoolKind
{
    /// <summary>Vehicles.</summary>
    Vehicles,

    /// <summary>People and animals.</summary>
    Peds,

    /// <summary>Objects.</summary>
    Props,
}
