using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Play.Settings;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Play.Tests.Settings;

public sealed class HarvestSettingsTests
{
    [Fact]
    public void Empty_file_gives_the_defaults()
    {
        Assert.Equal(Defaults, HarvestSettings.Read(IniFile.Read(TextReader.Null)));
    }

    [Fact]
    public void Every_setting_reaches_its_option()
    {
        IniFile ini = Read(
            """
            [Harvest]
            Width = 280
            Height = 210
            ImageFormat = jpeg
            JpegQuality = 80
            Rate = 2.5
            Range = 70
            IgnoreRange = 140
            Classes = car, bus
            Mode = Live
            Freeze = timeScale
            Masks = On
            Semantics = On
            Depth = On
            Rays = 3000
            RayReach = 120.5
            OcclusionRays = 9
            ProbeLag = Off
            CheckDisplay = Off
            MaxPictureLagTicks = 7
            TickBudget = 1.5
            Queue = 3
            MinFree = 2.5
            Sync = Always
            [Lens]
            MaxError = 0.4
            FocalScale = 1.008
            CentreOffsetX = 0.01
            CentreOffsetY = -0.02
            K1 = -0.1
            K2 = 0.03
            """
        );
        HarvestOptions options = HarvestSettings.Read(ini);

        Assert.Empty(ini.Complaints);
        Assert.Equal([ObjectClass.Car, ObjectClass.Bus], options.Classes);
        var expected = new HarvestOptions
        {
            Image = new ImageSize(280, 210),
            Format = ImageFormat.Jpeg,
            JpegQuality = 80,
            RateHz = 2.5,
            RangeMetres = 70,
            IgnoreRangeMetres = 140,
            Classes = options.Classes,
            Freeze = false,
            FreezeBy = FreezeMethod.TimeScale,
            Masks = true,
            Semantics = SemanticsMethod.Rays,
            Depth = true,
            RayBudget = 3000,
            RayReachMetres = 120.5,
            OcclusionSamples = 9,
            ProbeLag = false,
            ChecksDisplay = false,
            MaxPictureLagTicks = 7,
            TickBudgetMilliseconds = 1.5,
            Sync = SyncMode.Always,
            QueueCapacity = 3,
            MinFreeBytes = 2_500_000_000,
            MaxCalibrationErrorPixels = 0.4,
            Lens = new Lens(1.008, 0.01, -0.02, -0.1, 0.03),
        };
        Assert.Equal(expected, options);
    }

    [Fact]
    public void Pairs_are_lists_in_the_settings()
    {
        IniFile ini = Read(
            "[Harvest]\nPairWeathers = Clear, rain\nPairHours = 0,18\nPairWithout = signs, nearest-vehicle\nPairTicks = 99\n"
        );
        PairOptions pairs = HarvestSettings.Read(ini).Pairs;

        Assert.Empty(ini.Complaints);
        Assert.Equal(["clear", "rain"], pairs.Weathers);
        Assert.Equal([0, 18], pairs.Hours);
        Assert.Equal(["signs", "nearest-vehicle"], pairs.Without.Select(choice => choice.Name));
        Assert.Equal((99, false), (pairs.MaxTicks, pairs.TakesAllTicks));
    }

    [Theory]
    [InlineData("PairWeathers = sunny")]
    [InlineData("PairWeathers = rain, rain")]
    [InlineData("PairHours = 24")]
    [InlineData("PairWithout = trees")]
    public void Wrong_pairs_are_reported_and_not_taken(string setting)
    {
        IniFile ini = Read($"[Harvest]\n{setting}\n");

        Assert.False(HarvestSettings.Read(ini).Pairs.IsAny);
        Assert.StartsWith($"Line 2: {setting} is not a list of ", Assert.Single(ini.Complaints), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Paused", FreezeMethod.Paused)]
    [InlineData("TimeScale", FreezeMethod.TimeScale)]
    [InlineData("Auto", null)]
    public void Freeze_names_a_method_or_leaves_the_choice_to_a_trial(string value, FreezeMethod? expected) =>
        Assert.Equal(expected, HarvestSettings.Read(Read($"[Harvest]\nFreeze = {value}\n")).FreezeBy);

    [Fact]
    public void Lens_error_limit_of_zero_disables_the_check()
    {
        Assert.Null(HarvestSettings.Read(Read("[Lens]\nMaxError = 0\n")).MaxCalibrationErrorPixels);
    }

    [Fact]
    public void Bad_setting_names_its_line_and_what_is_expected()
    {
        IniFile ini = Read("[Harvest]\nMode = Freezing\nClasses = car, lorry\n");
        Assert.Equal(Defaults, HarvestSettings.Read(ini));

        Assert.Equal("Line 2: Mode = Freezing is not Freeze or Live; the default is used.", ini.Complaints[0]);
        Assert.StartsWith("Line 3: Classes = car, lorry is not a list of Car, Truck, Bus", ini.Complaints[1], StringComparison.Ordinal);
    }

    /// <summary>
    /// A player's game is frozen in the way that a trial finds better, slowly enough to drive by hand, and the display is checked; a
    /// program says itself what it wants.
    /// </summary>
    private static HarvestOptions Defaults =>
        new()
        {
            FreezeBy = null,
            RateHz = 2,
            ChecksDisplay = true,
        };

    private static IniFile Read(string text) => IniFile.Read(new StringReader(text));
}
