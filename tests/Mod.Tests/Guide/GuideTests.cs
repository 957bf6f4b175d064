using System.IO.Compression;
using System.Text.RegularExpressions;
using System.Windows.Forms;
using Harvester.Capture.Ports;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests.Guide;

/// <summary>
/// The player's first harvest as docs/mod.md describes it, played in the simulated game. The environment variable
/// GTADATAHARVESTER_PICTURES names the folder, docs/images/mod, to which its pictures are drawn.
/// </summary>
public sealed class GuideTests
{
    private const string PicturesVariable = "GTADATAHARVESTER_PICTURES";
    private const string Origin = "The mod in the simulated game that tests it; not GTA V.";
    private const int Seed = 12;
    private const int TicksUntilSomethingDrives = 60;
    private const int MinRectanglesOfABox = 4;
    private static readonly ImageSize Window = new(800, 600);

    private readonly HashSet<string> _shown = [];

    [Fact]
    [Trait("Category", "Heavy")]
    public void First_harvest_shows_the_messages_of_its_page()
    {
        var options = new SimulationOptions
        {
            Seed = Seed,
            Detail = Detail.Full,
            Lens = new RenderLens(1.004, 0, 0, -0.01, 0),
            TimeOfDay = TimeSpan.FromHours(10),
        };
        var scene = new SimulatedScene(options, FaceTable.Empty);
        using var driver = new ScriptDriver("[Harvest]\nRate = 2\n", scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        driver.Game.Roads = new FakeRoadSource(scene.Roads);

        driver.Press(Keys.NumPad0);
        UntilMessage(driver, "The test car is here");
        Draw(driver, scene, "1-test-car");

        driver.Press(Keys.I);
        UntilMessage(driver, "The camera is mounted");
        driver.Press(Keys.L);
        driver.Tick(TicksUntilSomethingDrives);
        Assert.True(driver.Game.Drawn.Count > MinRectanglesOfABox);
        Assert.True(driver.Game.Drawn.Select(rectangle => rectangle.Colour).Distinct().Count() > 1);
        Draw(driver, scene, "2-boxes");
        driver.Press(Keys.L);

        driver.Press(Keys.NumPad1);
        driver.Until(() => driver.Game.Balls.Count > 0);
        driver.Tick();
        Draw(driver, scene, "3-balls");
        UntilMessage(driver, "Calibrated: the error was");
        Draw(driver, scene, "4-calibrated");

        driver.Press(Keys.J);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("REC  6 frames", StringComparison.Ordinal)));
        Draw(driver, scene, "5-harvest");
        driver.Press(Keys.J);
        UntilMessage(driver, "The harvest ended");
        Draw(driver, scene, "6-ended");
        driver.WaitForDisk();
        string header = Assert.Single(Directory.GetFiles(driver.Output, "session.json", SearchOption.AllDirectories));
        Assert.Empty(SessionValidator.Validate(new SessionReader(Path.GetDirectoryName(header)!)).Problems);

        string[] quoted = QuotedMessages();
        Assert.NotEmpty(quoted);
        Assert.All(quoted, message => Assert.Contains(_shown, shown => shown.Contains(message, StringComparison.Ordinal)));
    }

    /// <summary>
    /// The messages in quotation marks that the page's steps of a first harvest promise, without numbers. Quotation marks in code belong to
    /// a path or a command.
    /// </summary>
    private static string[] QuotedMessages()
    {
        string page = File.ReadAllText(Path.Combine(BuiltMod.RepositoryRoot, "docs", "mod.md"));
        string steps = page.Split("## Your first harvest", 2)[1].Split("\n## ", 2)[0];
        string prose = Regex.Replace(steps, "`[^`]*`", "");
        return [.. Regex.Matches(prose, "\"([^\"]+)\"").Select(quote => WithoutNumbers(quote.Groups[1].Value.Replace('\n', ' ')))];
    }

    private static string WithoutNumbers(string text) => Regex.Replace(Regex.Replace(text, @"\s+", " "), @"\d+(\.\d+)?", "0").TrimEnd('.');

    private void UntilMessage(ScriptDriver driver, string message)
    {
        driver.UntilMessage(message);
        _shown.UnionWith(driver.Game.Notifications.Concat(driver.Game.Texts).Select(WithoutNumbers));
    }

    private void Draw(ScriptDriver driver, SimulatedScene scene, string name)
    {
        _shown.UnionWith(driver.Game.Texts.Select(WithoutNumbers));
        if (Environment.GetEnvironmentVariable(PicturesVariable) is not { Length: > 0 } folder)
        {
            return;
        }

        var picture = new GuidePicture(Window);
        Assert.Equal(GrabResult.Good, scene.Ports.Screen.Grab(picture.Pixels));
        foreach (DrawnRectangle rectangle in driver.Game.Drawn)
        {
            picture.Fill(rectangle);
        }

        foreach (DrawnText line in driver.Game.Lines)
        {
            // Free space and folders differ from machine to machine.
            picture.Write(line with { Text = Regex.Replace(line.Text, @"[\d.]+ GB", "250.0 GB") });
        }

        if (!driver.Game.IsFeedHidden && driver.Game.Notifications.Count > 0)
        {
            picture.Tell(driver.Game.Notifications[^1].Replace(driver.Output, @"Pictures\GtaDataHarvester", StringComparison.Ordinal));
        }

        picture.Label(Origin);
        using FileStream file = File.Create(Path.Combine(folder, name + ".png"));
        new PngEncoder(CompressionLevel.SmallestSize).Write(picture.Pixels, file);
    }
}
