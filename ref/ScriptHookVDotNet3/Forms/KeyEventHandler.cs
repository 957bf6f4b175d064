namespace System.Windows.Forms;

/// <summary>Handles a key event.</summary>
public delegate void KeyEventHandler(object? sender, KeyEventArgs e);
