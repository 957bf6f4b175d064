using System.Windows.Forms;
using GTA.Hosting;

namespace GTA;

/// <summary>A script of the game. The loader makes one and raises its events.</summary>
public abstract class Script
{
    /// <summary>Raised once a frame.</summary>
    public event EventHandler? Tick;

    /// <summary>Raised when the script ends, sometimes more than once, sometimes on another thread.</summary>
    public event EventHandler? Aborted;

    /// <summary>Raised when a key goes up.</summary>
    public event KeyEventHandler? KeyUp;

    /// <summary>Raised when a key goes down and again and again while it is held.</summary>
    public event KeyEventHandler? KeyDown;

    /// <summary>Full path of the script's file.</summary>
    public string Filename { get; } = GameHost.Current.ScriptFile;

    /// <summary>The folder that the script's file lies in.</summary>
    public string BaseDirectory => Path.GetDirectoryName(Filename)!;

    internal void RaiseTick() => Raise(() => Tick?.Invoke(this, EventArgs.Empty));

    internal void RaiseAborted() => Raise(() => Aborted?.Invoke(this, EventArgs.Empty));

    internal void RaiseKeyUp(Keys key) => Raise(() => KeyUp?.Invoke(this, new KeyEventArgs(key)));

    internal void RaiseKeyDown(Keys key) => Raise(() => KeyDown?.Invoke(this, new KeyEventArgs(key)));

    private static void Raise(Action handlers) =>
        ScriptThread.Run(() =>
        {
            handlers();
            return true;
        });
}
