namespace Harvester.Geometry.Motion;

/// <summary>How a body moves between two pictures.</summary>
public enum BodyMotionKind
{
    /// <summary>It stands still in the world.</summary>
    Static,

    /// <summary>It moves as a rigid body.</summary>
    Rigid,

    /// <summary>It is a person, whose body is not rigid.</summary>
    Person,

    /// <summary>It was not there at both times.</summary>
    Unknown,
}
