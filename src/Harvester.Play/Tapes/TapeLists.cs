namespace Harvester.Play.Tapes;

/// <summary>
/// The lists of nearby entities of the scripting API, as targets of calls; no native has such a hash. Asked are the centre, the radius and
/// the hashes of the models; written are the handles.
/// </summary>
public static class TapeLists
{
    /// <summary>Vehicles.</summary>
    public const ulong Vehicles = 1;

    /// <summary>People and animals.</summary>
    public const ulong Peds = 2;

    /// <summary>Objects.</summary>
    public const ulong Props = 3;
}
