namespace Harvester.Simulation.Rendering;

/// <summary>Draws streaks of rain and flakes of snow over the finished colours; depth and handles are unaffected.</summary>
internal static class Precipitation
{
    private const double DropsPerPixel = 0.0022;
    private const double FlakesPerPixel = 0.0030;

    /// <summary>Sizes of drops and flakes are given in pixels of an image of this height.</summary>
    private const double ReferenceHeight = 600;
    private static readonly Rgb Drop = new(200, 208, 218);
    private static readonly Rgb Flake = new(250, 250, 255);

    public static void Draw(Lighting lighting, RenderTarget target)
    {
        var random = new Random(lighting.PrecipitationSeed);
        double brightness = 1 - (0.65 * lighting.NightFraction);
        int pixels = target.Width * target.Height;
        for (int drop = 0; drop < pixels * DropsPerPixel * lighting.RainFraction; drop++)
        {
            double x = random.NextDouble() * target.Width;
            double y = random.NextDouble() * target.Height;
            double length = (8 + (random.NextDouble() * 22)) * target.Height / ReferenceHeight;
            double strength = 0.10 + (random.NextDouble() * 0.16);
            for (int step = 0; step < length; step++)
            {
                Blend(target, (int)(x - (step * 0.12)), (int)y + step, Drop.Scaled(brightness), strength);
            }
        }

        for (int flake = 0; flake < pixels * FlakesPerPixel * lighting.SnowFraction; flake++)
        {
            double x = random.NextDouble() * target.Width;
            double y = random.NextDouble() * target.Height;
            double radius = (0.5 + (random.NextDouble() * random.NextDouble() * 2.2)) * target.Height / ReferenceHeight;
            DrawDot(target, x, y, radius, Flake.Scaled(brightness));
        }
    }

    private static void DrawDot(RenderTarget target, double x, double y, double radius, Rgb colour)
    {
        for (int row = (int)(y - radius - 1); row <= y + radius + 1; row++)
        {
            for (int column = (int)(x - radius - 1); column <= x + radius + 1; column++)
            {
                double distance = Math.Sqrt(((column + 0.5 - x) * (column + 0.5 - x)) + ((row + 0.5 - y) * (row + 0.5 - y)));
                Blend(target, column, row, colour, Math.Clamp(radius + 0.5 - distance, 0, 1) * 0.85);
            }
        }
    }

    private static void Blend(RenderTarget target, int column, int row, Rgb colour, double share)
    {
        if (column < 0 || row < 0 || column >= target.Width || row >= target.Height || share <= 0)
        {
            return;
        }

        Span<byte> pixel = target.Colour.AsSpan(((row * target.Width) + column) * 3, 3);
        Rgb mixed = new Rgb(pixel[0], pixel[1], pixel[2]).Towards(colour, share);
        (pixel[0], pixel[1], pixel[2]) = (mixed.Red, mixed.Green, mixed.Blue);
    }
}
