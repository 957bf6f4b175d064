namespace Harvester.Exports;

/// <summary>Subclasses to split classes into.</summary>
[Flags]
public enum Subclasses
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Signs by MUTCD code: a sign with the code R1-1 has the class sign-R1-1.</summary>
    Mutcd = 1,

    /// <summary>Traffic lights by their state: trafficLight-red, -amber and -green.</summary>
    Light = 2,
}
