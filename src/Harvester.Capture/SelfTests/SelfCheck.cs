using Harvester.Capture.Ports;
using Harvester.Geometry.Work;

namespace Harvester.Capture.SelfTests;

/// <summary>One part of the self-test. It runs over many ticks; each step of the iteration ends one.</summary>
internal abstract class SelfCheck(SelfTestContext context)
{
    /// <summary>What it does, for the screen.</summary>
    public abstract string Title { get; }

    /// <summary>The checks for which it adds a line.</summary>
    public abstract IReadOnlyList<string> Checks { get; }

    protected SelfTestContext Context { get; } = context;

    protected GamePorts Game => Context.Game;

    /// <summary>Runs the check; an exception leaves the checks without a line untested.</summary>
    public abstract IEnumerable<WorkStep> Run();

    /// <summary>Gives back what the check took of the game, whatever happened.</summary>
    public virtual void Release() { }

    protected static IEnumerable<WorkStep> Wait(int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            yield return WorkStep.Tick;
        }
    }

    /// <summary>Throws unless grabbed pictures show the game.</summary>
    protected void NeedPictures()
    {
        if (!Context.ArePicturesUsable)
        {
            throw new SelfTestException("pictures do not show the game's window.");
        }
    }

    /// <summary>Freezes the world by the better method, and waits until it stands.</summary>
    protected IEnumerable<WorkStep> Freeze()
    {
        if (Context.BestFreeze is not { } best)
        {
            throw new SelfTestException("no freeze method stops the world.");
        }

        Game.Pause.Method = best.Method;
        Game.Pause.Freeze();
        return Wait(best.SettleTicks!.Value + SpareSettleTicks + Context.PictureTicks);
    }

    /// <summary>A freeze may take longer to settle than it took when it was tried.</summary>
    private const int SpareSettleTicks = 12;
}
