using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>How dark the shadows of a frame are: outside all screens, what changes between the pictures with and without objects.</summary>
internal static class FrameShadows
{
    /// <summary>Step between the rows and columns that are looked at.</summary>
    private const int Step = 2;

    /// <summary>Pixels darker than this in all three channels together tell nothing.</summary>
    private const int MinLight = 90;

    /// <summary>A pixel is in a shadow if less than this fraction of the light is left.</summary>
    private const double ShadowFraction = 0.9;

    /// <summary>One in this many shaded pixels is as dark as full shadows; they leave at least this part of what is left there.</summary>
    private const int DarkestOneIn = 10;
    private const double Slack = 0.9;

    /// <summary>Fewer shaded pixels tell nothing; then shadows may leave this fraction of the light.</summary>
    private const int MinPixels = 20;
    private const double Unknown = 0.12;

    /// <summary>The fraction of the light that shadows leave at least.</summary>
    /// <param name="image">The size of the pictures.</param>
    /// <param name="screens">The screens of all objects.</param>
    /// <param name="all">The picture with all objects.</param>
    /// <param name="none">The picture without objects.</param>
    public static double Darkest(ImageSize image, IReadOnlyList<ObjectScreen> screens, byte[] all, byte[] none)
    {
        List<double> left = [];
        for (int row = 0; row < image.Height; row += Step)
        {
            for (int column = 0; column < image.Width; column += Step)
            {
                int first = 3 * ((row * image.Width) + column);
                int lit = none[first] + none[first + 1] + none[first + 2];
                int now = all[first] + all[first + 1] + all[first + 2];
                if (lit > MinLight && now < ShadowFraction * lit && !screens.Any(screen => screen.Spans.Contains(column, row)))
                {
                    left.Add((double)now / lit);
                }
            }
        }

        left.Sort();

        // The darkest tenth are taken for full shadows; its lightest pixel and some slack give the bound, which single dark pixels do not
        // move.
        return left.Count >= MinPixels ? Slack * left[left.Count / DarkestOneIn] : Unknown;
    }
}
