namespace System.Windows.Forms;

/// <summary>What a key event tells, where Windows Forms is not there to say so.</summary>
public class KeyEventArgs : EventArgs
{
    /// <summary>Makes the event's data.</summary>
    public KeyEventArgs(Keys keyData) => KeyCode = keyData;

    /// <summary>The key.</summary>
    public Keys KeyCode { get; }
}
