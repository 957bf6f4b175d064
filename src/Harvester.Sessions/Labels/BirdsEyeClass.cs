namespace Harvester.Sessions.Labels;

/// <summary>What a cell of a bird's-eye map shows; the numbers are those of its pixels.</summary>
public enum BirdsEyeClass : byte
{
    /// <summary>None of the others, or unknown.</summary>
    Other = 0,

    /// <summary>The surface of a road outside lanes: junctions, shoulders, parking strips.</summary>
    Drivable = 1,

    /// <summary>A lane.</summary>
    Lane = 2,

    /// <summary>Paint on the road outside crossings: lines, stop lines, arrows.</summary>
    Line = 3,

    /// <summary>The area of a pedestrian crossing.</summary>
    Crossing = 4,

    /// <summary>A vehicle other than the ego.</summary>
    Vehicle = 5,

    /// <summary>A person on foot or on a vehicle with two wheels.</summary>
    Person = 6,
}
