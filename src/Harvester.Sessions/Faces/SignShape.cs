namespace Harvester.Sessions.Faces;

/// <summary>The outline of a sign's face within its rectangle.</summary>
public enum SignShape
{
    /// <summary>A rectangle: the face fills its cuboid.</summary>
    Rectangle,

    /// <summary>A regular octagon with a horizontal side: STOP.</summary>
    Octagon,

    /// <summary>A triangle on its tip: YIELD.</summary>
    Triangle,

    /// <summary>A square on a corner: warnings.</summary>
    Diamond,
}
