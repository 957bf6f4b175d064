using Harvester.Capture.Harvesting;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>Takes pictures of the frozen world in which nothing is changed, and finds what changes nevertheless.</summary>
internal sealed class StillPictureCheck(SelfTestContext context) : SelfCheck(context)
{
    /// <summary>Pictures that are taken, one a tick: more than half a second, in which details are loaded.</summary>
    private const int Pictures = 40;

    /// <summary>Pictures are compared over this many ticks, in which a moving texture changes clearly.</summary>
    private const int ApartTicks = 4;

    /// <summary>A pixel has changed if it differs by more, grey levels, and by more than this multiple of the noise.</summary>
    private const int ChangedLevels = 12;
    private const double OverNoise = 20;

    /// <summary>Fewer pixels are noise.</summary>
    private const int MinPixels = 24;

    /// <summary>Noise is measured in this fraction of the channels, those that differ least.</summary>
    private const double QuietFraction = 0.6;

    /// <summary>Pictures whose quiet channels differ by more have noise, grey levels.</summary>
    private const double NoiseLevels = 0.25;

    public override string Title => "two equal photographs";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Noise, SelfTestChecks.Textures, SelfTestChecks.LevelOfDetail];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        Game.Hud?.Hide();
        yield return WorkStep.Do(Freeze());

        var last = new Queue<PixelBuffer>();
        var differences = new List<double>();
        var changed = new List<List<int>>();
        for (int number = 0; number < Pictures; number++)
        {
            PixelBuffer now = Context.Grab();
            if (last.Count == ApartTicks)
            {
                PixelBuffer before = last.Dequeue();
                double noise = NoiseBetween(before, now);
                differences.Add(noise);
                changed.Add(PicturePixels.Changed(before, now, (int)Math.Max(ChangedLevels, OverNoise * noise)));
            }

            last.Enqueue(now);
            yield return WorkStep.Tick;
        }

        Judge(differences, changed);
    }

    private void Judge(List<double> differences, List<List<int>> changed)
    {
        double noise = differences.OrderBy(value => value).ElementAt(differences.Count / 2);
        Context.Add(
            SelfTestChecks.Noise,
            noise > NoiseLevels ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"The quieter pixels of two equal photographs differ by {noise:0.0} of 255."
        );
        List<int>[] clear = [.. changed.Where(pixels => pixels.Count >= MinPixels)];
        bool isLasting = 2 * clear.Length > changed.Count;
        Context.Add(
            SelfTestChecks.Textures,
            isLasting ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"{(isLasting ? "Parts" : "No parts")} of the picture keep changing while the world is frozen."
        );
        bool isOnce = clear.Length > 0 && !isLasting;
        string where = isOnce ? $" ({PictureRegion.Of(clear[0], Context.Options.Image)})" : string.Empty;
        Context.Add(
            SelfTestChecks.LevelOfDetail,
            isOnce ? SelfTestVerdict.Problem : SelfTestVerdict.Good,
            $"{(isOnce ? "A part" : "No part")} of the picture changes once while the world is frozen, ",
            $"as when the level of detail changes{where}."
        );
    }

    /// <summary>
    /// The mean difference of the quietest channels of two pictures, grey levels: noise is in all of them, and what moves in places is not.
    /// </summary>
    private static double NoiseBetween(PixelBuffer a, PixelBuffer b)
    {
        var counts = new int[byte.MaxValue + 1];
        for (int i = 0; i < a.Bytes.Length; i++)
        {
            counts[Math.Abs(a.Bytes[i] - b.Bytes[i])]++;
        }

        int quiet = (int)(QuietFraction * a.Bytes.Length);
        int left = quiet;
        long sum = 0;
        for (int level = 0; left > 0; level++)
        {
            int taken = Math.Min(left, counts[level]);
            sum += (long)taken * level;
            left -= taken;
        }

        return (double)sum / quiet;
    }
}
