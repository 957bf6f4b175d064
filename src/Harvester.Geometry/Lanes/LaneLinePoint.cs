namespace Harvester.Geometry.Lanes;

/// <summary>A point of a lane boundary or a painted marking in an image.</summary>
/// <param name="World">Metres, world.</param>
/// <param name="InCamera">Metres in the camera's frame: x right, y forward, z up.</param>
/// <param name="Pixel">Continuous pixels, within the image.</param>
/// <param name="IsHidden">Whether something nearer hides it, as found by rays; null if no ray was cast.</param>
public readonly record struct LaneLinePoint(Vector3D World, Vector3D InCamera, Vector2D Pixel, bool? IsHidden)
{
    /// <summary>
    /// Whether there is paint at this point of a painted marking; false on a boundary, and in the gap of a dashed marking.
    /// </summary>
    public bool IsPainted { get; init; }
}
