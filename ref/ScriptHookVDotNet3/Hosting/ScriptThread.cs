namespace GTA.Hosting;

/// <summary>The thread that runs a script's constructor or one of its events. Only this thread may call the API.</summary>
internal static class ScriptThread
{
    [ThreadStatic]
    private static int _depth;

    /// <summary>Runs a part of a script on this thread, which is the script's meanwhile.</summary>
    public static T Run<T>(Func<T> part)
    {
        _depth++;
        try
        {
            return part();
        }
        finally
        {
            _depth--;
            PinnedStrings.Free();
        }
    }

    /// <summary>Reports a call from another thread to the host, and refuses it.</summary>
    /// <exception cref="InvalidOperationException">This thread is not the script's.</exception>
    public static void Require(string called)
    {
        if (_depth == 0)
        {
            GameHost.Current.Report($"A thread that is not the script's called {called}.");
            throw new InvalidOperationException("Native.Function.Call can only be called from the main thread.");
        }
    }
}
