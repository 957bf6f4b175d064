using System.Runtime.CompilerServices;
using GTA.Native;
using Harvester.Mod.Tests.Games;
using Harvester.Mod.Tests.Games.Natives;

namespace Harvester.Mod.Tests.Soak;

/// <summary>
/// The faults of a game, each for some ticks: natives that throw or answer with garbage, lists that fail, an abort in the middle of a tick.
/// </summary>
internal sealed class SoakFaults
{
    private const int MaxTicksOfFault = 40;

    /// <summary>Natives that report whether something exists. If the game denies that something exists, no script can remove it.</summary>
    private static readonly HashSet<string> Existence = ["DOES_ENTITY_EXIST", "DOES_CAM_EXIST", "GET_RENDERING_CAM"];

    private readonly ScriptDriver _driver;
    private readonly TestGame _game;
    private readonly Random _random;
    private readonly FaultTally _tally;
    private int _ticksLeft;

    public SoakFaults(ScriptDriver driver, Random random, FaultTally tally)
    {
        _driver = driver;
        _game = driver.Game;
        _random = random;
        _tally = tally;
    }

    /// <summary>Whether the script was ended in the middle of the tick that runs, or ran last.</summary>
    public bool HasAbortedTheTick { get; private set; }

    public void ResetTick() => HasAbortedTheTick = false;

    /// <summary>Begins and ends faults.</summary>
    public void Tick()
    {
        if (_ticksLeft > 0 && --_ticksLeft == 0)
        {
            Stop();
        }
        else if (_ticksLeft == 0 && _random.Next(30) == 0)
        {
            _ticksLeft = 1 + _random.Next(MaxTicksOfFault);
            Begin();
        }
    }

    /// <summary>From now on the game does as it should.</summary>
    public void Stop()
    {
        _ticksLeft = 0;
        _game.Fault = _ => null;
        _game.Lies = _ => null;
        _game.BrokenList = null;
        _game.ScriptHandlePoolIsFull = false;
        _game.VehiclePoolIsFull = false;
        _game.ObjectPoolIsFull = false;
        _game.ModelsLoad = true;
        _driver.Screen.Refusal = null;
    }

    private void Begin()
    {
        switch (_random.Next(10))
        {
            case 0 or 1:
                Hash broken = AnyNative();
                _game.Fault = native => native == broken ? Threw() : null;
                break;
            case 2:
                int oneIn = 1 + _random.Next(50);
                _game.Fault = _ => _random.Next(oneIn) == 0 ? Threw() : null;
                break;
            case 3 or 4:
                string lying = AnyNative().ToString();
                _game.Lies = native => native.Name == lying ? Lie(native) : null;
                break;
            case 5:
                int lieIn = 1 + _random.Next(50);
                _game.Lies = native => _random.Next(lieIn) == 0 ? Lie(native) : null;
                break;
            case 6:
                AbortAfter(_random.Next(60));
                break;
            case 7:
                BreakLists();
                break;
            case 8:
                _tally.Add("pool was full");
                _game.ScriptHandlePoolIsFull = _random.Next(2) == 0;
                _game.VehiclePoolIsFull = _random.Next(2) == 0;
                _game.ObjectPoolIsFull = _random.Next(2) == 0;
                _game.ModelsLoad = _random.Next(2) == 0;
                break;
            default:
                _tally.Add("picture was refused");
                _driver.Screen.Refusal = "covered";
                break;
        }
    }

    private Hash AnyNative()
    {
        // Half the time one that is in use.
        IReadOnlyList<Hash> choice = _game.Calls.Count > 0 && _random.Next(2) == 0 ? _game.Calls : Enum.GetValues<Hash>();
        return choice[_random.Next(choice.Count)];
    }

    private Exception Threw()
    {
        _tally.Add("native threw");
        return _random.Next(3) switch
        {
            0 => new InvalidOperationException("The native is broken."),
            1 => new KeyNotFoundException("Nothing is there."),
            _ => new ArithmeticException("Not a number."),
        };
    }

    /// <summary>Only who answers can lie: what a native without an answer does is what it does.</summary>
    private Random? Lie(NativeSignature native)
    {
        bool answers = !native.Result.IsVoid || native.Name is "GET_ENTITY_MATRIX" or "GET_MODEL_DIMENSIONS" or "GET_VEHICLE_NODE_POSITION";
        if (!answers || Existence.Contains(native.Name))
        {
            return null;
        }

        _tally.Add("native lied");
        return _random;
    }

    private void BreakLists()
    {
        switch (_random.Next(3))
        {
            case 0:
                _tally.Add("list threw");
                _game.BrokenList = BrokenListTests.Throw;
                break;
            case 1:
                _tally.Add("list was empty");
                _game.BrokenList = _ => [];
                break;
            default:
                _tally.Add("list lied");
                _game.BrokenList = _ => [.. Enumerable.Range(0, _random.Next(50)).Select(_ => _random.Next(int.MinValue, int.MaxValue))];
                break;
        }
    }

    /// <summary>
    /// After some natives the loader finds the script hanging: it raises Aborted twice on its own thread, while the script's is in the
    /// middle of a native that does nothing, and then stops that thread.
    /// </summary>
    private void AbortAfter(int natives)
    {
        int left = natives;
        _game.Fault = _ =>
        {
            if (left-- > 0)
            {
                return null;
            }

            Stop();
            HasAbortedTheTick = true;
            OtherThread.Do(() =>
            {
                RefuseCall();
                _driver.Script.RaiseAborted();
                _driver.Script.RaiseAborted();
            });
            return (ThreadAbortException)RuntimeHelpers.GetUninitializedObject(typeof(ThreadAbortException));
        };
    }

    /// <summary>
    /// Calls from another thread than the script's are refused, as everywhere; they do not count as a misuse by the script.
    /// </summary>
    private void RefuseCall()
    {
        Assert.Throws<InvalidOperationException>(() => Function.Call<int>(Hash.PLAYER_PED_ID));
        Assert.Single(_game.Misuses);
        _game.Misuses.Clear();
        _tally.Add("thread of another was refused");
    }
}
