using System.Runtime.ExceptionServices;

namespace Harvester.Mod.Tests;

/// <summary>Work on another thread; a task that is waited for may run on the waiting thread.</summary>
internal static class OtherThread
{
    /// <summary>Does work and waits for its end; an exception of the work's is thrown here.</summary>
    public static void Do(Action work)
    {
        ExceptionDispatchInfo? failure = null;
        var thread = new Thread(() =>
        {
            try
            {
                work();
            }
#pragma warning disable CA1031 // Whatever it is, it is thrown on the thread that waits.
            catch (Exception exception)
#pragma warning restore CA1031
            {
                failure = ExceptionDispatchInfo.Capture(exception);
            }
        });
        thread.Start();
        thread.Join();
        failure?.Throw();
    }
}
