using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Harvesting;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.SelfTests;

/// <summary>Takes pictures of the frozen world in which nothing is changed, and finds what changes nevertheless.</summary>
internal sealed class StillPictureCheck(SelfTestContext context) : SelfCheck(context)
{
    /// <summary>Pictures that are taken, one a tick: more than half a second, in which details are loaded.</summary>
    private const int Pictures = 40;

    /// <summary>Pictures are compared over so many ticks, in which a moving texture changes clearly.</summary>
    private const int ApartTicks = 4;

    /// <summary>A pixel has changed if it differs by more, grey levels, and by more than this multiple of the mean difference.</summary>
    private const int ChangedLevels = 12;
    private const double OverMean = 8;

    /// <summary>Fewer pixels are noise.</summary>
    private const int MinPixels = 24;

    /// <summary>Pictures whose pixels differ by more on the average have noise, grey levels.</summary>
    private const double NoiseLevels = 0.5;

    public override string Title => "two equal photographs";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Noise, SelfTestChecks.Textures, SelfTestChecks.LevelOfDetail];

    public override IEnumerable<SelfTestPhase> Run()
    {
        NeedPictures();
        Game.Hud?.Hide();
        foreach (SelfTestPhase phase in Freeze())
        {
            yield return phase;
        }

        var last = new Queue<PixelBuffer>();
        var differences = new List<double>();
        var changed = new List<List<int>>();
        for (int number = 0; number < Pictures; number++)
        {
            PixelBuffer now = Context.Grab();
            if (last.Count == ApartTicks)
            {
                PixelBuffer before = last.Dequeue();
                double median = MedianOf(before, now);
                differences.Add(median);
                changed.Add(PicturePixels.Changed(before, now, (int)Math.Max(ChangedLevels, OverMean * median)));
            }

            last.Enqueue(now);
            yield return SelfTestPhase.Running;
        }

        Judge(differences, changed);
    }

    private void Judge(List<double> differences, List<List<int>> changed)
    {
        double noise = differences.OrderBy(value => value).ElementAt(differences.Count / 2);
        Context.Add(
            SelfTestChecks.Noise, noise > NoiseLevels ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"Pixels of two equal photographs differ by {noise:0.0} of 255.");
        List<int>[] clear = [.. changed.Where(pixels => pixels.Count >= MinPixels)];
        bool isLasting = 2 * clear.Length > changed.Count;
        Context.Add(
            SelfTestChecks.Textures, isLasting ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"{(isLasting ? "Parts" : "No parts")} of the picture keep changing while the world is frozen.");
        bool isOnce = clear.Length > 0 && !isLasting;
        string where = isOnce ? $" ({PictureRegion.Of(clear[0], Context.Options.Image)})" : string.Empty;
        Context.Add(
            SelfTestChecks.LevelOfDetail, isOnce ? SelfTestVerdict.Problem : SelfTestVerdict.Good,
            $"{(isOnce ? "A part" : "No part")} of the picture changes once while the world is frozen, ",
            $"as when the level of detail changes{where}.");
    }

    /// <summary>
    /// The median over the blocks of the picture of the mean difference, grey levels: what changes in places does not count.
    /// </summary>
    private static double MedianOf(PixelBuffer a, PixelBuffer b)
    {
        const int blocks = 64;
        double[] means = [.. Enumerable.Range(0, blocks).Select(block =>
        {
            int first = (int)((long)block * a.Bytes.Length / blocks);
            int end = (int)((long)(block + 1) * a.Bytes.Length / blocks);
            long sum = 0;
            for (int i = first; i < end; i++)
            {
                sum += Math.Abs(a.Bytes[i] - b.Bytes[i]);
            }

            return (double)sum / (end - first);
        }).OrderBy(mean => mean)];
        return means[blocks / 2];
    }
}
