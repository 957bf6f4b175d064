namespace Harvester.Simulation.People;

/// <summary>What a person wears below the waist.</summary>
internal enum Outfit
{
    /// <summary>Long trousers.</summary>
    Trousers,

    /// <summary>Shorts, with bare shanks.</summary>
    Shorts,

    /// <summary>A skirt down to the knees.</summary>
    Skirt,

    /// <summary>A coat over trousers.</summary>
    Coat,
}
