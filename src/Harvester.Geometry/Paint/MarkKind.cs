namespace Harvester.Geometry.Paint;

/// <summary>What a painted area of the road means.</summary>
public enum MarkKind
{
    /// <summary>A bar across the lanes of one direction, at which vehicles stop.</summary>
    StopLine,

    /// <summary>A pedestrian crossing: parallel bars along the road, side by side across it.</summary>
    Crossing,

    /// <summary>An arrow that points straight on, to vehicles that drive towards the junction.</summary>
    ArrowStraight,

    /// <summary>An arrow that points to their left.</summary>
    ArrowLeft,

    /// <summary>An arrow that points to their right.</summary>
    ArrowRight,
}
