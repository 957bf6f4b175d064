using GTA;
using GTA.Hosting;
using GTA.Math;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>The stand-in is as strict as the API that it replaces: ref/README.md names where the real one does the same.</summary>
public sealed class StandInTests
{
    private const string NoFolder = "nowhere";
    private readonly TestGame _game = new(NoFolder);

    public StandInTests() => GameHost.Current = _game;

    [Fact]
    public void Output_accepts_no_int_as_its_initial_value() => Assert.Throws<InvalidCastException>(() => new OutputArgument(5));

    [Fact]
    public void Output_accepts_a_native_value_as_its_initial_value()
    {
        using var output = new OutputArgument(new Model(-5));

        Assert.Equal(-5, output.GetResult<int>());
    }

    [Fact]
    public void Output_holds_garbage_until_it_is_written()
    {
        using var output = new OutputArgument();

        Assert.NotEqual(0, output.GetResult<int>());
        Assert.True(output.GetResult<bool>());
    }

    [Fact]
    public void Output_of_null_is_zero_in_its_first_eight_bytes_only()
    {
        using var output = new OutputArgument(null);

        Assert.False(output.GetResult<bool>());
        Assert.Equal(0, output.GetResult<Vector3>().X);
        Assert.NotEqual(0, output.GetResult<Vector3>().Y);
    }

    [Fact]
    public void Disposed_output_cannot_be_passed()
    {
        var output = new OutputArgument();
        output.Dispose();

        Assert.Throws<ObjectDisposedException>(() =>
        {
            InputArgument argument = output;
        });
    }

    [Theory]
    [InlineData(1, true)]
    [InlineData(4, true)]
    [InlineData(8, false)]
    public void Bool_output_is_read_from_eight_bytes_whatever_was_written(int written, bool expected)
    {
        _game.BoolBytes = written;
        using var hit = new OutputArgument();
        using var point = new OutputArgument();
        using var normal = new OutputArgument();
        using var material = new OutputArgument();
        using var entity = new OutputArgument();
        OnScriptThread(() =>
        {
            int test = Function.Call<int>(Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE, 0f, 0f, 100f, 0f, 0f, 200f, 1, 0, 7);
            return Function.Call<int>(Hash.GET_SHAPE_TEST_RESULT_INCLUDING_MATERIAL, test, hit, point, normal, material, entity);
        });

        Assert.Equal(expected, hit.GetResult<bool>());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    public void Bool_result_is_right_whatever_was_written(int written)
    {
        _game.BoolBytes = written;

        Assert.True(OnScriptThread(() => Function.Call<bool>(Hash.DOES_ENTITY_EXIST, TestGame.Player)));
        Assert.False(OnScriptThread(() => Function.Call<bool>(Hash.DOES_ENTITY_EXIST, TestGame.Player + 1)));
    }

    [Fact]
    public void Slots_keep_the_values_of_earlier_calls()
    {
        OnScriptThread(() => Function.Call<int>(Hash.DOES_CAM_EXIST, TestGame.Player));

        Assert.True(OnScriptThread(() => Function.Call<bool>(Hash.DOES_ENTITY_EXIST)));
        Assert.Contains("DOES_ENTITY_EXIST takes 1 arguments and got 0.", _game.Misuses);
    }

    [Fact]
    public void Argument_or_result_of_the_wrong_type_is_reported()
    {
        OnScriptThread(() => Function.Call<float>(Hash.DOES_ENTITY_EXIST, 1f));

        Assert.Equal(
            ["DOES_ENTITY_EXIST returns BOOL and was read as Single.", "DOES_ENTITY_EXIST takes Entity as argument 0 and got Single."],
            _game.Misuses.Order(StringComparer.Ordinal)
        );
    }

    [Fact]
    public void Strings_reach_the_game_in_utf8_and_null_as_no_address()
    {
        int car = _game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "asea",
                Pose = new Pose(Vector3D.Zero, Axes.Identity),
            }
        );
        Set("Straße");
        Assert.Equal("Straße", _game.Entities[car].Plate);
        Set(null);
        Assert.Null(_game.Entities[car].Plate);

        void Set(string? plate) =>
            OnScriptThread(() =>
            {
                Function.Call(Hash.SET_VEHICLE_NUMBER_PLATE_TEXT, car, plate!);
                return true;
            });
    }

    [Fact]
    public void Call_from_another_thread_is_reported_and_refused()
    {
        OnScriptThread(() => Assert.Throws<InvalidOperationException>(() => OtherThread.Do(() => Function.Call<int>(Hash.PLAYER_PED_ID))));

        Assert.Contains("not the script's", Assert.Single(_game.Misuses), StringComparison.Ordinal);
        Assert.Empty(_game.Calls);
    }

    private static T OnScriptThread<T>(Func<T> part) => ScriptThread.Run(part);
}
