using GTA.Native;
using Harvester.Mod.Tests.Games.Natives;

namespace Harvester.Mod.Tests;

/// <summary>Every native that the mod can call, and every call that it makes, is as the table of natives says.</summary>
public sealed class NativeTableTests
{
    [Fact]
    public void Hashes_of_the_fake_equal_those_of_the_table() =>
        Assert.All(Enum.GetValues<Hash>(), native => Assert.Equal(native.ToString(), NativeTable.ByHash[(ulong)native].Name));

    [Fact]
    public void Every_native_call_has_the_arguments_and_result_of_the_table()
    {
        IReadOnlyList<WrittenCall> calls = WrittenCalls.Read(BuiltMod.Path);

        Assert.Empty(Enum.GetValues<Hash>().Except(calls.Select(call => call.Native)));
        Assert.Empty(
            calls.SelectMany(call =>
                NativeTable.ByHash[(ulong)call.Native].MistakesIn(call.Passed, call.Expected).Select(mistake => $"{call.Place}: {mistake}")
            )
        );
    }

    [Fact]
    public void Every_call_of_a_scenario_matches_the_native_table()
    {
        using var driver = new ScriptDriver(Playthrough.Ini, faces: LightTests.TableOfOne);
        Playthrough.Of(driver);
        using ScriptDriver hiding = HidingTests.Harvesting();
        hiding.Until(() => hiding.Game.Calls.Contains(Hash.DRAW_POLY));
        using ScriptDriver rig = RigTests.Harvesting();
        rig.Until(() => rig.Game.Calls.Contains(Hash.SET_CAM_FOV));
        using ScriptDriver actors = ActorTests.Playing();

        ScriptDriver[] all = [driver, hiding, rig, actors];
        Assert.Empty(Enum.GetValues<Hash>().Except(all.SelectMany(each => each.Game.Calls)));
        Assert.Empty(all.SelectMany(each => each.Game.Misuses));
    }
}
