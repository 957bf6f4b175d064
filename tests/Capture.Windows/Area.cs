namespace Harvester.Capture.Windows;

/// <summary>A rectangle of the desktop in physical pixels.</summary>
internal readonly record struct Area(int Left, int Top, int Width, int Height);
