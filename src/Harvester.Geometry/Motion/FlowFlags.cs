namespace Harvester.Geometry.Motion;

/// <summary>
/// What is known of the motion of a pixel between two pictures. Of <see cref="Valid"/>, <see cref="Person"/> and <see cref="Unknown"/> at
/// most one is set; if none is, the flow is not representable and <see cref="LeavesPicture"/> is set.
/// </summary>
[Flags]
public enum FlowFlags : byte
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>The flow is known.</summary>
    Valid = 1,

    /// <summary>The surface moved in the world.</summary>
    Moved = 2,

    /// <summary>Another surface hides the point in the other picture.</summary>
    Covered = 4,

    /// <summary>The point is outside the other picture. Without <see cref="Valid"/> it is behind the camera, or too far outside.</summary>
    LeavesPicture = 8,

    /// <summary>The surface is a person, whose body is not rigid; the flow is not known.</summary>
    Person = 16,

    /// <summary>The depth is unknown, or what the pixel shows was not there at both times.</summary>
    Unknown = 32,

    /// <summary>Nothing is seen, as in the sky; the flow is that of a point at infinity.</summary>
    Infinite = 64,
}
