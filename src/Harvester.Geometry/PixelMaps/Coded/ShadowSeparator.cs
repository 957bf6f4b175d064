using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Separates an object from its shadow on what is behind it. Both change with the object. A shadow is recognised by its colour, which is
/// that of the background times the light that shadows of this frame leave, and by the texture of the background, which is still there.
/// Evidence is shared with the pixels around.
/// </summary>
internal sealed class ShadowSeparator(Camera camera, NoiseMap noise, ShadowLight light)
{
    /// <summary>Texture is compared over this many rows and columns on each side.</summary>
    private const int TextureReach = 2;

    /// <summary>Overlapping windows see the same texture, so each counts for part of it only.</summary>
    private const double TextureWeight = 0.35;

    /// <summary>No single pixel decides: evidence of colour and of texture is limited to this.</summary>
    private const double MaxEvidence = 8;
    private const int SmoothRounds = 2;

    /// <summary>The ground is seen below a vehicle under this height, metres.</summary>
    private const double Clearance = 0.3;

    /// <summary>A shadow is looked for on the ground within this many times half the diagonal of its object's cuboid.</summary>
    private const double GroundReach = 4;

    /// <summary>Minimum number of pixels of a window whose texture is compared.</summary>
    private const int MinTexturePixels = 6;

    /// <summary>Variance of rounding the grey level, 1/12 for a channel and so 1/36 for a mean of three, with room to spare.</summary>
    private const double RoundingVariance = 0.05;

    /// <summary>Logarithms of how much more likely a shadow is than the object, by where the line of sight passes.</summary>
    private const double Never = -50;
    private const double Behind = -6;
    private const double Below = 0;
    private const double Outside = 4;

    /// <summary>Marks the pixels of a plane that show the object's shadow.</summary>
    public void Separate(ObjectPlane plane)
    {
        var evidence = new double[plane.State.Length];
        for (int y = 0; y < plane.Height; y++)
        {
            for (int x = 0; x < plane.Width; x++)
            {
                int index = (y * plane.Width) + x;
                if (plane.State[index] == PixelState.Object)
                {
                    evidence[index] = OpticalEvidence(plane, x, y);
                }
            }
        }

        // Neighbours show the same thing more often than not: two means over 3 x 3 pixels spread the evidence over 5 x 5.
        double[] smooth = evidence;
        for (int round = 0; round < SmoothRounds; round++)
        {
            smooth = Smoothed(plane, smooth);
        }

        for (int index = 0; index < evidence.Length; index++)
        {
            if (plane.State[index] == PixelState.Object && smooth[index] > 0)
            {
                plane.State[index] = PixelState.Shadow;
            }
        }
    }

    private double OpticalEvidence(ObjectPlane plane, int x, int y)
    {
        double expectation = Expectation(plane, x, y);
        return !light.IsAny || expectation == Never
            ? Never
            : Limited(ColourEvidence(plane, x, y)) + Limited(TextureEvidence(plane, x, y)) + expectation;
    }

    private static double Limited(double value) => Math.Max(-MaxEvidence, Math.Min(MaxEvidence, value));

    private double VarianceAt(ObjectPlane plane, int x, int y) => noise.At(((y + plane.Top) * camera.Image.Width) + x + plane.Left);

    /// <summary>
    /// What the place says: the ground is seen in the silhouette of an object below it, around its feet, or behind it. A line of sight that
    /// does not come down to the ground near the object meets no shadow of it there.
    /// </summary>
    private double Expectation(ObjectPlane plane, int x, int y)
    {
        Ray ray = camera.RayThrough(x + plane.Left + 0.5, y + plane.Top + 0.5);
        Cuboid cuboid = plane.Target.Cuboid;
        Vector3D up = cuboid.Axes.Up;

        // The ground is the plane of the cuboid's underside. The ray descends by descent metres per metre from height metres above it, and
        // so meets it after height / descent metres.
        double height = (ray.Origin - cuboid.Centre).Dot(up) + cuboid.HalfExtents.Z;
        double descent = -ray.Direction.Dot(up);
        if (height <= 0 || descent <= 0)
        {
            return Never;
        }

        double ground = height / descent;
        double reach = cuboid.HalfExtents.Length * GroundReach;
        if ((ray.Origin + (ray.Direction * ground) - cuboid.Centre).Length > reach)
        {
            return Never;
        }

        // Beside the cuboid a change can only be the shadow. Where the ray enters it below the clearance, the ground shows under the body;
        // higher up, the body is in the way.
        return cuboid.Intersect(ray) is not { } span ? Outside
            : height - (descent * span.Entry) < Clearance ? Below
            : Behind;
    }

    private double ColourEvidence(ObjectPlane plane, int x, int y)
    {
        int index = (y * plane.Width) + x;
        double variance = VarianceAt(plane, x, y);
        return light.Evidence(
            plane.ColourAt(index),
            plane.BehindAt(index),
            variance / plane.Counts[2 * index],
            variance / plane.Counts[(2 * index) + 1]
        );
    }

    /// <summary>
    /// Compares how well the texture behind, darkened, explains that in front with how well an even surface does: the difference of the
    /// squared deviations in units of the noise.
    /// </summary>
    private double TextureEvidence(ObjectPlane plane, int x, int y)
    {
        (double a, double g, double gg, double ag, int count) = (0, 0, 0, 0, 0);
        double noises = 0;
        for (int v = y - TextureReach; v <= y + TextureReach; v++)
        {
            for (int u = x - TextureReach; u <= x + TextureReach; u++)
            {
                if (plane.Has(u, v))
                {
                    int index = (v * plane.Width) + u;

                    // Sums for the regression of the front's grey level on that behind.
                    double front = Grey(plane.Colours, index);
                    double behind = Grey(plane.Behind, index);
                    a += front;
                    g += behind;
                    gg += behind * behind;
                    ag += front * behind;
                    noises += 1.0 / plane.Counts[2 * index];
                    count++;
                }
            }
        }

        if (count < MinTexturePixels || g <= 0)
        {
            return 0;
        }

        // The darkening r is the ratio of the means. variation is Σ(behind - mean)², shared is Σ(front - mean)(behind - mean).
        double ratio = Math.Min(1, a / g);
        double variation = gg - (g * g / count);
        double shared = ag - (a * g / count);
        double variance = (VarianceAt(plane, x, y) * noises / count / 3) + RoundingVariance;

        // A shadow leaves Σ(front' - r·behind')², an even surface Σfront'², where ' is the deviation from the mean. Their difference is
        // 2r·shared - r²·variation; its unit is the variance of front - r·behind, (1 + r²)·v, and ½ makes it a logarithm of likelihood.
        double gain = (2 * ratio * shared) - (ratio * ratio * variation);
        return TextureWeight * gain / (2 * variance * (1 + (ratio * ratio)));
    }

    private static double Grey(float[] colours, int index) =>
        (colours[3 * index] + colours[(3 * index) + 1] + colours[(3 * index) + 2]) / 3;

    private static double[] Smoothed(ObjectPlane plane, double[] evidence)
    {
        var smooth = new double[evidence.Length];
        for (int y = 0; y < plane.Height; y++)
        {
            for (int x = 0; x < plane.Width; x++)
            {
                if (!plane.Has(x, y))
                {
                    continue;
                }

                (double sum, int count) = (0, 0);
                for (int v = y - 1; v <= y + 1; v++)
                {
                    for (int u = x - 1; u <= x + 1; u++)
                    {
                        if (plane.Has(u, v))
                        {
                            sum += evidence[(v * plane.Width) + u];
                            count++;
                        }
                    }
                }

                smooth[(y * plane.Width) + x] = sum / count;
            }
        }

        return smooth;
    }
}
