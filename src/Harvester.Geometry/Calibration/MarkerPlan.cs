using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>
/// Balls at known positions that a camera sees in a grid over its whole image, at depths that change from ball to ball: an error of the
/// camera's position, unlike one of its lens, then shows as different errors at neighbours. Each ball is displaced from its grid point by
/// up to half a radius along either axis, so that the fractional parts of their pixel positions differ: in an even grid, location errors
/// that depend on that fraction would repeat from ball to ball and look like a lens. A displaced grid also does not match itself when
/// shifted by one cell.
/// </summary>
public sealed class MarkerPlan
{
    private MarkerPlan(IReadOnlyList<PlannedMarker> markers, double spacingPixels)
    {
        Markers = markers;
        SpacingPixels = spacingPixels;
    }

    /// <summary>The balls, row by row from the image's upper left corner.</summary>
    public IReadOnlyList<PlannedMarker> Markers { get; }

    /// <summary>Minimum distance of neighbours, pixels, in the smaller of the two directions.</summary>
    public double SpacingPixels { get; }

    /// <summary>
    /// Plans a grid of balls. The outermost ones lie wholly within the image, at least two and a half radii from its edges.
    /// </summary>
    /// <param name="camera">The camera as far as it is known; with an unknown lens, balls may appear elsewhere or not at all.</param>
    /// <param name="columns">Balls per row, at least 2.</param>
    /// <param name="rows">Rows, at least 2.</param>
    /// <param name="radiusPixels">Radius of a ball in the image, pixels, greater than 0.</param>
    /// <param name="depths">Depths along the camera's axis, metres, greater than 0, used in turn; at least one.</param>
    /// <exception cref="ArgumentException">A value is out of range, or the image is too small for this number of balls.</exception>
    public static MarkerPlan Across(Camera camera, int columns, int rows, double radiusPixels, IReadOnlyList<double> depths)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(depths, nameof(depths));
        if (columns < 2 || rows < 2 || depths.Count == 0)
        {
            throw new ArgumentException("A grid of markers has at least 2 columns, 2 rows and a depth.");
        }

        // Three radii: half of one for the displacement, and two and a half for the ball and the room around it.
        double margin = 3 * Guard.Positive(radiusPixels, nameof(radiusPixels));
        double stepX = (camera.Image.Width - (2 * margin)) / (columns - 1);
        double stepY = (camera.Image.Height - (2 * margin)) / (rows - 1);
        double spacing = Math.Min(stepX, stepY);
        if (spacing < margin)
        {
            throw new ArgumentException($"{columns} x {rows} markers do not fit into {camera.Image.Width} x {camera.Image.Height} pixels.");
        }

        var markers = new List<PlannedMarker>(columns * rows);
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                Vector2D pixel =
                    new Vector2D(margin + (column * stepX), margin + (row * stepY)) + (BesideGrid(markers.Count) * radiusPixels);
                markers.Add(Marker(camera, pixel, radiusPixels, depths[(column + row) % depths.Count]));
            }
        }

        return new MarkerPlan(markers, spacing - radiusPixels);
    }

    /// <summary>Displacement of a ball from its grid point, radii, -0.5 to 0.5 along either axis.</summary>
    private static Vector2D BesideGrid(int index) =>
        new(Fraction((index + 1) * R2Sequence.First) - 0.5, Fraction((index + 1) * R2Sequence.Second) - 0.5);

    private static double Fraction(double value) => value - Math.Floor(value);

    private static PlannedMarker Marker(Camera camera, Vector2D pixel, double radiusPixels, double depth)
    {
        Vector3D centre = camera.Unproject(pixel.X, pixel.Y, depth);

        // A ball at the angle θ and the distance depth / cos θ covers r pixels along the radius when it covers the angle r cos²(θ) / f.
        double cosine = depth / (centre - camera.Pose.Position).Length;
        return new PlannedMarker(centre, radiusPixels * cosine * depth / camera.Intrinsics.Fy, pixel);
    }
}
