using System;

namespace Harvester.Datasets.Exports;

/// <summary>What classes are divided by.</summary>
[Flags]
public enum Subclasses
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>Signs by their MUTCD code: a sign with the code R1-1 is of the class sign-R1-1.</summary>
    Mutcd = 1,

    /// <summary>Traffic lights by their state: trafficLight-red, -amber and -green.</summary>
    Light = 2,
}
