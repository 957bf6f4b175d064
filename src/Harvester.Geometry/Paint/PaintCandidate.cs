namespace Harvester.Geometry.Paint;

/// <summary>A bright stripe with two edges in one row of one image.</summary>
/// <param name="Image">Number of the image.</param>
/// <param name="Offset">Its middle, metres to the right of the link's curve.</param>
/// <param name="Width">Distance of its edges, metres.</param>
/// <param name="Contrast">Brightness above that of the asphalt beside it, as a fraction of the latter.</param>
/// <param name="Blueness">Blue divided by the mean of red and green, as a fraction of the same quotient of the asphalt: about 1 for white
/// paint, clearly less for yellow.</param>
/// <param name="Sigma">Standard deviation of the offset, metres.</param>
public readonly record struct PaintCandidate(int Image, float Offset, float Width, float Contrast, float Blueness, float Sigma);
