namespace Harvester.Sessions.Faces;

/// <summary>The outline of a sign's face within its rectangle.</summary>
public enum SignShape
{
    /// <summary>A rectangle: the face fills its cuboid.</summary>
    Rectangle,

    /// <summary>A regular octagon that stands on a side: STOP.</summary>
    Octagon,

    /// <summary>A triangle that stands on its tip: YIELD.</summary>
    Triangle,

    /// <summary>A square that stands on a corner: warnings.</summary>
    Diamond,
}
