extern alias tapes;

using System.Text;
using System.Windows.Forms;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Tapes;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Settings;
using tapes::Harvester.Tapes;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>What the mod records in a game is played by its own code without the game.</summary>
public sealed class TapeTests
{
    /// <summary>The quirks of the simulated game, one by one.</summary>
    public static TheoryData<string> Quirks => [.. Quirk.Keys];

    /// <summary>Several quirks at a time.</summary>
    public static TheoryData<string> QuirkCombinations => [.. Combination.Keys];

    private static readonly Dictionary<string, GameQuirks> Quirk = new()
    {
        ["none"] = new(),
        ["creeping"] = new() { Paused = new() { CreepTicks = 3 } },
        ["no standstill"] = new() { Paused = new() { NeverStands = true } },
        ["camera held"] = new() { Paused = new() { HoldsCamera = true } },
        ["picture lag"] = new() { PictureLagTicks = 2 },
        ["late camera"] = new() { IsCameraReportedLate = true },
        ["vanishing"] = new() { VanishingFraction = 0.2 },
        ["rays meet boxes"] = new() { RaysMeetBoxes = true },
        ["rays miss"] = new() { RayMissFraction = 0.2 },
        ["noise"] = new() { PictureNoiseLevels = 3 },
    };

    private static readonly Dictionary<string, GameQuirks> Combination = new()
    {
        ["creeping, lag, late camera"] = new()
        {
            Paused = new() { CreepTicks = 3 },
            PictureLagTicks = 2,
            IsCameraReportedLate = true,
        },
        ["vanishing, rays miss, noise"] = new()
        {
            VanishingFraction = 0.2,
            RayMissFraction = 0.2,
            PictureNoiseLevels = 3,
        },
        ["camera held, boxes, lag"] = new()
        {
            Paused = new() { HoldsCamera = true },
            RaysMeetBoxes = true,
            PictureLagTicks = 1,
        },
        ["no standstill, late camera, vanishing, noise"] = new()
        {
            Paused = new() { NeverStands = true },
            IsCameraReportedLate = true,
            VanishingFraction = 0.1,
            PictureNoiseLevels = 2,
        },
    };

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Quirks))]
    public void Tape_of_a_game_with_a_quirk_plays_to_its_end(string quirk) => AssertPlays(Quirk[quirk]);

    [Theory]
    [MemberData(nameof(QuirkCombinations))]
    [Trait("Category", "Heavy")]
    public void Tape_of_a_game_with_quirks_plays_to_its_end(string quirks) => AssertPlays(Combination[quirks]);

    private static void AssertPlays(GameQuirks quirks)
    {
        TapeResult result = RecordedGame.Play(RecordedGame.Harvest(RecordedGame.Options with { Quirks = quirks }));

        Assert.Null(result.Difference);
        Assert.False(result.IsInterrupted);
        Assert.Equal(RecordedGame.Ticks + 2, result.Ticks);
        Assert.InRange(result.Calls, 1000, int.MaxValue);
    }

    [Fact]
    public void Tape_of_a_harvest_plays_to_its_end()
    {
        TapeResult result = RecordedGame.Play(RecordedGame.Plain);

        Assert.Null(result.Difference);
        Assert.Equal(RecordedGame.Ticks + 2, result.Ticks);
    }

    /// <summary>Its checks measure pixels, so the tape needs them.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Tape_of_a_self_test_plays_to_its_end()
    {
        var scene = new SimulatedScene(new SimulationOptions { Seed = 9 }, FaceTable.Empty);
        using var driver = new ScriptDriver(
            "[Tape]\nRecord = NativesAndPictures\n[Harvest]\nWidth = 320\nHeight = 240\n",
            scene.PlayIn,
            scene.Ports.Screen,
            scene.Ports.Clock
        );
        driver.Press(Keys.T);
        driver.UntilMessage("The self-test ended");

        TapeResult result = RecordedGame.Play(RecordedGame.TapeOf(driver));

        Assert.Null(result.Difference);
        Assert.InRange(result.Ticks, 100, int.MaxValue);
    }

    /// <summary>It is not on the tape: only a message depends on it.</summary>
    [Fact]
    public void Graphics_settings_make_no_difference()
    {
        using var driver = new ScriptDriver(RecordedGame.Ini);
        File.WriteAllText(driver.GraphicsFile, "<Settings><graphics><MSAA value=\"4\" /></graphics></Settings>");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        driver.UntilMessage("Settings of the game harm pictures and labels");
        driver.Press(Keys.L);
        driver.Tick(3);

        TapeResult result = RecordedGame.Play(RecordedGame.TapeOf(driver));

        Assert.Null(result.Difference);
        Assert.InRange(result.Calls, 10, int.MaxValue);
    }

    /// <summary>What is on the disk while the game still runs is what a crash leaves.</summary>
    [Fact]
    public void Tape_of_a_game_that_crashed_plays_without_its_last_part()
    {
        using var scene = new TemporaryFolder();
        var town = new SimulatedScene(RecordedGame.Options, FaceTable.Empty);
        using var driver = new ScriptDriver(RecordedGame.Ini + RecordedGame.Busy, town.PlayIn, town.Ports.Screen, town.Ports.Clock);
        driver.Press(Keys.J);
        driver.Until(() => Directory.GetFiles(driver.Output, "*.tape").Any(path => new FileInfo(path).Length > 0));
        driver.WaitForDisk();
        string copy = Path.Combine(scene.Path, "crashed.tape");
        File.Copy(Assert.Single(Directory.GetFiles(driver.Output, "*.tape")), copy);

        TapeResult result = RecordedGame.Play(File.ReadAllBytes(copy));

        Assert.True(result.IsInterrupted);
        Assert.Null(result.Difference);
        Assert.InRange(result.Calls, 100, int.MaxValue);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Tape_of_every_feature_plays_up_to_what_it_lacks()
    {
        using var driver = new ScriptDriver(RecordedGame.Ini + Playthrough.Ini, faces: LightTests.TableOfOne);
        Playthrough.Of(driver);

        TapeResult result = RecordedGame.Play(RecordedGame.TapeOf(driver));

        // The commands of a client are not on the tape: with its drive the playback ends.
        Assert.True(result.Ticks > 400, $"{result.Difference}");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Game_that_answers_otherwise_gives_a_difference()
    {
        EditedTape tape = new(RecordedGame.Plain);
        int coordinates = tape.Entries.FindLastIndex(entry =>
            entry is TapeCall call && call.Target == (ulong)GTA.Native.Hash.GET_ENTITY_MODEL
        );
        var call = (TapeCall)tape.Entries[coordinates];
        tape.Entries[coordinates] = call with { Asked = [TapeValue.Of(call.Asked[0].Whole + 1)] };

        TapeResult result = RecordedGame.Play(tape.Bytes());

        Assert.Equal(tape.TickOf(coordinates), result.Difference!.Tick);
        Assert.Equal(tape.CallOf(coordinates), result.Difference.Call);
        Assert.Equal($"GET_ENTITY_MODEL({call.Asked[0].Whole + 1})", result.Difference.Expected);
        Assert.Equal($"GET_ENTITY_MODEL({call.Asked[0].Whole})", result.Difference.Got);
        Assert.Equal(tape.CallOf(coordinates) - 1, result.Calls);
    }

    [Fact]
    public void Mod_with_a_new_question_plays_up_to_it()
    {
        EditedTape tape = new(RecordedGame.Plain);
        int removed = tape.Entries.FindLastIndex(entry => entry is TapeCall { Target: TapeLists.Vehicles });
        tape.Entries.RemoveAt(removed);

        TapeResult result = RecordedGame.Play(tape.Bytes());

        Assert.Equal(tape.TickOf(removed), result.Difference!.Tick);
        Assert.StartsWith("the list of vehicles(", result.Difference.Got, StringComparison.Ordinal);
        Assert.Equal(tape.TickOf(removed) - 1, result.Ticks);
    }

    /// <summary>The mod asks for entities within the larger of its two ranges.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Mod_with_another_argument_plays_up_to_it()
    {
        byte[] recorded = RecordedGame.Harvest(RecordedGame.Options, RecordedGame.Busy + "Range = 100\nIgnoreRange = 200\n");
        EditedTape tape = new(recorded);
        int settings = tape.Entries.FindIndex(entry => entry is TapeFact { Name: TapeFacts.Settings });
        var fact = (TapeFact)tape.Entries[settings];
        tape.Entries[settings] = fact with { Text = fact.Text.Replace("Range = 200", "Range = 190", StringComparison.Ordinal) };
        Assert.NotEqual(fact, tape.Entries[settings]);

        TapeDifference difference = RecordedGame.Play(tape.Bytes()).Difference!;

        int first = tape.Entries.FindIndex(entry => entry is TapeCall call && call.Asked.Contains(TapeValue.Of(200f)));
        Assert.Null(RecordedGame.Play(recorded).Difference);
        Assert.Equal(tape.TickOf(first), difference.Tick);
        Assert.Equal(tape.CallOf(first), difference.Call);
        Assert.Matches(@"^the list of \w+\(<.*>, 200[,)]", difference.Expected);
        Assert.Matches(@"^the list of \w+\(<.*>, 190[,)]", difference.Got);
    }

    [Fact]
    public void Mod_without_a_recorded_question_plays_up_to_it()
    {
        EditedTape tape = new(RecordedGame.Plain);
        int tick = tape.Entries.FindLastIndex(entry => entry is TapeTick);
        tape.Entries.Insert(tick, new TapeCall((ulong)GTA.Native.Hash.PLAYER_PED_ID, [], TapeValue.Of(1), []));

        TapeDifference difference = RecordedGame.Play(tape.Bytes()).Difference!;

        Assert.Equal("PLAYER_PED_ID()", difference.Expected);
        Assert.StartsWith("no further call", difference.Got, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Floats_of_another_machine_are_no_difference()
    {
        EditedTape tape = new(RecordedGame.Plain);
        int changed = 0;
        for (int i = 0; i < tape.Entries.Count; i++)
        {
            if (tape.Entries[i] is TapeCall call && call.Asked.Any(value => value.Kind == TapeValueKind.Real))
            {
                tape.Entries[i] = call with { Asked = [.. call.Asked.Select(value => value with { X = MathF.BitIncrement(value.X) })] };
                changed++;
            }
        }

        Assert.InRange(changed, 100, int.MaxValue);
        Assert.Null(RecordedGame.Play(tape.Bytes()).Difference);
    }

    [Fact]
    public void Pictures_are_recorded_and_played_if_wanted()
    {
        byte[] tape = RecordedGame.Harvest(RecordedGame.Options, recording: "[Tape]\nRecord = NativesAndPictures\n");
        TapeGrab[] grabs = [.. new EditedTape(tape).Entries.OfType<TapeGrab>()];

        Assert.InRange(grabs.Length, 3, 1000);
        Assert.All(grabs, grab => Assert.Equal(3 * 64 * 48, grab.Pixels!.Length));
        Assert.Null(RecordedGame.Play(tape).Difference);
    }

    [Fact]
    public void Tape_has_no_paths_names_or_texts()
    {
        const string plate = "SMITH";
        byte[] tape;
        using (var driver = new ScriptDriver(RecordedGame.Ini + $"[TestCar]\nPlate = {plate}\n[Plan]\nFile = {plate}.json\n"))
        {
            HarvestTests.Street(driver.Game);
            driver.Press(Keys.NumPad0);
            driver.Tick(10);
            driver.Press(Keys.J);
            driver.Tick(30);
            Assert.Contains(GTA.Native.Hash.ADD_TEXT_COMPONENT_SUBSTRING_PLAYER_NAME, driver.Game.Calls);
            tape = RecordedGame.TapeOf(driver);
            Assert.DoesNotContain(driver.Folder, TextOf(tape), StringComparison.Ordinal);
        }

        string text = TextOf(tape);
        Assert.Contains("[TestCar]", text, StringComparison.Ordinal);
        Assert.All(
            [plate, "REC", Environment.UserName + Path.DirectorySeparatorChar, Path.GetTempPath()],
            name => Assert.DoesNotContain(name, text, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Keys_without_an_action_are_not_recorded()
    {
        using var driver = new ScriptDriver(RecordedGame.Ini);
        driver.Press(Keys.Q);
        driver.Press(Keys.L);

        Assert.Equal([(int)Keys.L], new EditedTape(RecordedGame.TapeOf(driver)).Entries.OfType<TapeKey>().Select(key => key.Key));
    }

    /// <summary>The whole content of a tape as text.</summary>
    private static string TextOf(byte[] tape) => Encoding.Latin1.GetString(new EditedTape(tape).Encoded());
}
