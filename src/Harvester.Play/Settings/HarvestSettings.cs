using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Events;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Play.Settings;

/// <summary>The sections [Harvest] and [Lens] of a settings file.</summary>
public static class HarvestSettings
{
    private const string Harvest = HarvestSection;
    private const double BytesPerGigabyte = 1e9;

    /// <summary>Name of the section about harvests.</summary>
    public const string HarvestSection = "Harvest";

    /// <summary>
    /// Frames per second of game time while the player drives. The game stops for each frame, so that a minute at 10 frames a second takes
    /// many minutes. Plans and the bridge have rates of their own.
    /// </summary>
    private const double RateByHandHz = 2;

    /// <summary>
    /// Readings per second in which events are looked for: a reading of everything near costs the game a few milliseconds.
    /// </summary>
    public const double EventRateHz = 10;

    /// <summary>The options of a file; missing and invalid values have their defaults.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="ini"/> is null.</exception>
    public static HarvestOptions Read(IniFile ini)
    {
        if (ini is null)
        {
            throw new ArgumentNullException(nameof(ini));
        }

        var fallback = new HarvestOptions { RateHz = RateByHandHz };
        IReadOnlyList<ObjectClass> classes = ini.Choices<ObjectClass>(
            Harvest,
            "Classes",
            [],
            "a list of " + string.Join(", ", typeof(ObjectClass).GetEnumNames())
        );
        MaskChoice masks = ini.Choice(Harvest, "Masks", MaskChoice.Off, "Off, Rays, Coded or Both");
        bool semantics = ini.Choice(Harvest, "Semantics", Switch.Off, "On or Off") == Switch.On;
        Switch events = ini.Choice(Harvest, "Events", Switch.Off, "On or Off");
        double eventRate = ini.Number(Harvest, "EventRate", EventRateHz, 0.1, 60);
        return fallback with
        {
            Image = new ImageSize(
                ini.Whole(Harvest, "Width", fallback.Image.Width, 16, 7680),
                ini.Whole(Harvest, "Height", fallback.Image.Height, 16, 4320)
            ),
            Format = ini.Choice(Harvest, "ImageFormat", fallback.Format, "Png, Bmp or Jpeg"),
            JpegQuality = ini.Whole(Harvest, "JpegQuality", fallback.JpegQuality, JpegEncoder.MinQuality, JpegEncoder.MaxQuality),
            RateHz = ini.Number(Harvest, "Rate", fallback.RateHz, 0.01, 60),
            RangeMetres = ini.Number(Harvest, "Range", fallback.RangeMetres, 1, 1000),
            IgnoreRangeMetres = ini.Number(Harvest, "IgnoreRange", fallback.IgnoreRangeMetres, 0, 1000),
            Classes = classes.Count > 0 ? classes : null,
            Freeze = ini.Choice(Harvest, "Mode", CaptureMode.Freeze, "Freeze or Live") == CaptureMode.Freeze,
            FreezeBy = FreezeByOf(ini.Choice(Harvest, "Freeze", FreezeChoice.Auto, "Paused, TimeScale or Auto")),
            Masks = masks != MaskChoice.Off || semantics,
            MaskMethod = masks switch
            {
                MaskChoice.Coded => MaskMethod.Coded,
                MaskChoice.Both => MaskMethod.Both,
                _ => MaskMethod.Rays,
            },
            Semantics = semantics ? SemanticsMethod.Rays : null,
            Channels = new ChannelKeys(
                FrameChannels
                    .All.Where(channel => channel.Switch is { } own && ini.Choice(Harvest, own.Name, Switch.Off, "On or Off") == Switch.On)
                    .Select(channel => channel.Key)
            ),
            ImuNoise = ImuNoiseOf(ini),
            GnssNoise = GnssNoiseOf(ini),
            BirdsEye = BirdsEyeOf(ini),
            Motion = ini.Choice(Harvest, "Motion", Switch.Off, "On or Off") == Switch.On,
            Events = events == Switch.On ? new EventOptions { RateHz = eventRate } : null,
            Pairs = PairsOf(ini),
            RayBudget = ini.Whole(Harvest, "Rays", fallback.RayBudget, 0, LabellingOptions.MaxRays),
            RayReachMetres = ini.Number(Harvest, "RayReach", fallback.RayReachMetres, 1, 100_000),
            OcclusionSamples = ini.Whole(Harvest, "OcclusionRays", fallback.OcclusionSamples, 1, 10_000),
            ProbeLag = ini.Choice(Harvest, "ProbeLag", Switch.On, "On or Off") == Switch.On,
            ChecksDisplay = ini.Choice(Harvest, "CheckDisplay", Switch.On, "On or Off") == Switch.On,
            MaxPictureLagTicks = ini.Whole(Harvest, "MaxPictureLagTicks", fallback.MaxPictureLagTicks, 1, 60),
            TickBudgetMilliseconds = ini.Number(Harvest, "TickBudget", fallback.TickBudgetMilliseconds, 0.1, 1000),
            Sync = ini.Choice(Harvest, "Sync", fallback.Sync, "Batch, Always or Never"),
            MinFreeBytes = (long)(ini.Number(Harvest, "MinFree", fallback.MinFreeBytes / BytesPerGigabyte, 0, 1e6) * BytesPerGigabyte),
            QueueCapacity = ini.Whole(Harvest, "Queue", fallback.QueueCapacity, 1, 1000),
            Lens = LensSettings.Read(ini),
            MaxCalibrationErrorPixels = ini.Number(LensSettings.Section, "MaxError", fallback.MaxCalibrationErrorPixels ?? 0, 0, 100)
                is > 0
                    and var error
                ? error
                : null,
        };
    }

    private static ImuNoise? ImuNoiseOf(IniFile ini)
    {
        IReadOnlyList<string> parts = ini.List(
            Harvest,
            "ImuNoise",
            $"a list of {ImuNoise.Form}, {ImuNoise.Limits}, or {ImuNoise.Adis16448}",
            text => ImuNoise.Parse(text) is null ? null : text
        );
        return parts.Count > 0 ? ImuNoise.Parse(string.Join(",", parts)) : null;
    }

    private static GnssNoise? GnssNoiseOf(IniFile ini)
    {
        IReadOnlyList<string> parts = ini.List(
            Harvest,
            "GnssNoise",
            $"a list of {GnssNoise.Form}, {GnssNoise.Limits}",
            text => GnssNoise.Parse(text) is null ? null : text
        );
        return parts.Count > 0 ? GnssNoise.Parse(string.Join(",", parts)) : null;
    }

    /// <summary>The size of bird's-eye maps: as asked, the nearest with whole cells, or the usual one if that is out of range.</summary>
    private static GridShape BirdsEyeOf(IniFile ini)
    {
        double side = ini.Number(Harvest, "BirdsEyeSize", GridShape.Usual.SideMetres, GridShape.MinSide, GridShape.MaxSide);
        double cell = ini.Number(Harvest, "BirdsEyeCell", GridShape.Usual.CellMetres, GridShape.MinCell, GridShape.MaxCell);
        var asked = new GridShape(side, cell);
        int cells = Math.Min(asked.Cells, GridShape.MaxCells);
        return new[] { asked, Whole(cells), Whole(cells - 1), Whole(cells + 1), GridShape.Usual }.First(shape => shape.Problem is null);

        GridShape Whole(int count) => new(count * cell, cell);
    }

    private static PairOptions PairsOf(IniFile ini)
    {
        var fallback = new PairOptions();
        string[] allHours = [.. Enumerable.Range(0, 24).Select(hour => hour.ToString(CultureInfo.InvariantCulture))];
        IReadOnlyList<string> hours = ini.List(
            Harvest,
            "PairHours",
            "a list of whole hours from 0 to 23",
            text => allHours.Contains(text) ? text : null
        );
        return fallback with
        {
            Weathers = ini.List(
                Harvest,
                "PairWeathers",
                "a list of " + string.Join(", ", WeatherNames.All),
                text => WeatherNames.IsKnown(text.ToLowerInvariant()) ? text.ToLowerInvariant() : null
            ),
            Hours = hours.Count == 0 ? fallback.Hours : [.. hours.Select(text => int.Parse(text, CultureInfo.InvariantCulture))],
            Without = ini.List(Harvest, "PairWithout", "a list of " + HiddenChoice.Form, HiddenChoice.Parse),
            MaxTicks = ini.Whole(Harvest, "PairTicks", fallback.MaxTicks, 10, 10_000),
        };
    }

    private static FreezeMethod? FreezeByOf(FreezeChoice choice) =>
        choice switch
        {
            FreezeChoice.Paused => FreezeMethod.Paused,
            FreezeChoice.TimeScale => FreezeMethod.TimeScale,
            _ => null,
        };
}
