namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// A part of a cell cut off by the straight chord between two changes on its border. A second number in it begins at a third change and is
/// separated from the first by the line from there to the chord's middle: the picture of a silhouette that ends at a nearer one.
/// </summary>
internal readonly record struct CellCap(Vector2D Start, Vector2D End, int FirstNumber, int SecondNumber, Vector2D Change)
{
    public Vector2D ChordMiddle => (Start + End) * 0.5;

    public bool HasTwoNumbers => FirstNumber != SecondNumber;

    // The border is walked clockwise on the screen, so the cap lies to the left of its chord: a negative cross product with y downward.
    public bool Contains(Vector2D pixel) => (End - Start).Cross(pixel - Start) < 0;

    public int NumberAt(Vector2D pixel) => HasTwoNumbers && (ChordMiddle - Change).Cross(pixel - Change) <= 0 ? SecondNumber : FirstNumber;
}
