namespace Harvester.Geometry.Paint;

/// <summary>The part of a row that an image shows. Offsets are metres to the right of the link's curve.</summary>
/// <param name="Image">Number of the image.</param>
/// <param name="Left">First offset.</param>
/// <param name="Right">Last offset.</param>
/// <param name="CameraOffset">Offset of the camera.</param>
/// <param name="EdgeSigma">Standard deviation of an edge in the image, metres on the ground.</param>
/// <param name="HeightSigma">Standard deviation of the height of the ground, as a fraction of the camera's height above it.</param>
public readonly record struct SeenSpan(int Image, float Left, float Right, float CameraOffset, float EdgeSigma, float HeightSigma)
{
    /// <summary>
    /// Standard deviation of an offset, metres: sqrt(e² + (r (o - c))²), with e of the edge, r of the height and c of the camera, because
    /// an error dz of the ground's height moves a point by dz / h times its lateral distance from the camera.
    /// </summary>
    public double SigmaAt(double offset)
    {
        double lateral = HeightSigma * (offset - CameraOffset);
        return Math.Sqrt((EdgeSigma * EdgeSigma) + (lateral * lateral));
    }
}
