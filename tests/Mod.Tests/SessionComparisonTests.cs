using System.Text.Json;
using System.Text.RegularExpressions;
using System.Windows.Forms;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests;

/// <summary>The mod is only an adapter: it harvests the same as a harvest of the same scene without it.</summary>
public sealed class SessionComparisonTests
{
    private const int Ticks = 24;
    private const string Ini = "[Harvest]\nWidth = 64\nHeight = 48\nRate = 5\nMasks = On\nOcclusionRays = 16\n";

    [Fact]
    [Trait("Category", "Heavy")]
    public void Session_of_the_mod_equals_one_recorded_without_it()
    {
        FaceTable faces = ReadFaces(out string table);
        using var folder = new TemporaryFolder();
        string direct = Path.Combine(folder.Path, "direct");
        HarvestDirectly(new SimulatedScene(Options(), faces), faces, direct);

        var scene = new SimulatedScene(Options(), faces);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock, table);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        driver.Tick(Ticks);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        string byMod = Assert.Single(Directory.GetDirectories(driver.Output));

        string[] labels = File.ReadAllLines(Path.Combine(direct, "labels.jsonl"));
        Assert.InRange(labels.Length, 3, Ticks);
        AssertScenePutsEverythingToTheTest(labels);

        // The game does not tell which lamps of a vehicle shine, nor how the car is driven.
        Assert.Equal(labels.Select(AsOfTheGame), File.ReadAllLines(Path.Combine(byMod, "labels.jsonl")));
        foreach (string file in Files(direct, "frames").Concat(Files(direct, "masks")))
        {
            Assert.Equal(File.ReadAllBytes(Path.Combine(direct, file)), File.ReadAllBytes(Path.Combine(byMod, file)));
        }

        Assert.Equal(Files(direct, "frames"), Files(byMod, "frames"));
        Assert.Empty(SchemaValidator.Problems(new SessionReader(byMod)));
    }

    private static string AsOfTheGame(string line) =>
        Regex.Replace(Regex.Replace(line, ",\"lights\":\\{[^}]*\\}", ""), ",\"yawRate\":[^}]*", "");

    /// <summary>In a scene without traffic, people, signals or hidden objects, a mod that reads none of them would pass.</summary>
    private static void AssertScenePutsEverythingToTheTest(string[] labels)
    {
        JsonElement[] objects = labels
            .SelectMany(line => JsonDocument.Parse(line).RootElement.GetProperty("objects").EnumerateArray())
            .ToArray();
        string?[] classes = objects.Select(label => label.GetProperty("class").GetString()).Distinct().ToArray();

        Assert.All(["car", "truck", "pedestrian", "trafficLight"], expected => Assert.Contains(expected, classes));
        Assert.Contains(objects, label => label.GetProperty("velocity").EnumerateArray().Any(speed => speed.GetDouble() != 0));
        Assert.Contains(objects, label => label.GetProperty("occludedFraction").GetDouble() > 0);
    }

    private static SimulationOptions Options() =>
        new()
        {
            Seed = 14,
            TrafficDensity = 2,
            PedestrianDensity = 12,
        };

    private static void HarvestDirectly(SimulatedScene scene, FaceTable faces, string directory)
    {
        var options = new HarvestOptions
        {
            Image = new ImageSize(64, 48),
            RateHz = 5,
            Masks = true,
            OcclusionSamples = 16,
            ProbeLag = false,
            Faces = faces,
        };
        using var writer = new SessionWriter(directory, new SessionOrigin { Game = "test", Tool = "test" });
        using var session = new HarvestSession(options, scene.Ports, writer);
        for (int tick = 0; tick < Ticks; tick++)
        {
            scene.NextFrame();
            Assert.Null(session.Step().Fault);
            writer.WaitForRoom();
        }
    }

    private static IEnumerable<string> Files(string session, string kind) =>
        Directory.GetFiles(Path.Combine(session, kind)).Select(path => Path.GetRelativePath(session, path)).Order(StringComparer.Ordinal);

    private static FaceTable ReadFaces(out string text)
    {
        text = File.ReadAllText(Path.Combine(BuiltMod.RepositoryRoot, "data", "spaces_of_interest.csv"));
        using var reader = new StringReader(text);
        return FaceTableReader.Read(reader).Table;
    }
}
