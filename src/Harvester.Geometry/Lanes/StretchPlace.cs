namespace Harvester.Geometry.Lanes;

/// <summary>A position on a stretch of road.</summary>
/// <param name="Piece">The link.</param>
/// <param name="Station">Metres along the road from the car; negative behind it.</param>
/// <param name="Offset">Metres to the right of the centre line in the direction of travel.</param>
public readonly record struct StretchPlace(StretchPiece Piece, double Station, double Offset)
{
    /// <summary>Metres to the right of the left edge of the leftmost lane.</summary>
    public double OffsetFromLeftEdge => Offset - Piece.LanesAt(Station).LeftEdge;
}
