using Harvester.Play.Settings;

namespace Harvester.Play.Features;

/// <summary>Reads the game's graphics settings once, on another thread, and warns of those that harm pictures or labels.</summary>
/// <param name="read">Reads them; what it throws is logged.</param>
/// <param name="messages">Shows the warning.</param>
public sealed class GraphicsAdvice(Func<GraphicsSettings> read, PlayerMessages messages) : ILastingFeature
{
    private Task<GraphicsSettings>? _reading;
    private bool _isDone;

    /// <inheritdoc/>
    public string Name => "The graphics settings";

    /// <inheritdoc/>
    public bool IsOn => false;

    /// <inheritdoc/>
    public bool IsBusy => _reading is { IsCompleted: false };

    /// <inheritdoc/>
    public void Tick()
    {
        if (_isDone)
        {
            return;
        }

        _reading ??= Task.Run(read);
        if (_reading.IsCompleted)
        {
            _isDone = true;
            Tell(_reading);
        }
    }

    /// <inheritdoc/>
    public void Stop() => _isDone = true;

    /// <inheritdoc/>
    public void Finish() => Stop();

    private void Tell(Task<GraphicsSettings> reading)
    {
        if (reading.IsFaulted)
        {
            messages.Log($"The game's settings.xml was not read: {reading.Exception!.InnerException!.Message}");
            return;
        }

        GraphicsSettings settings = reading.Result;
        if (settings.PausesWithoutFocus == true)
        {
            messages.Log("Pause Game On Focus Loss is on: the game stops while another window has the focus.");
        }

        string harmful = string.Join(", ", settings.Harmful);
        if (harmful.Length > 0)
        {
            messages.Tell($"Settings of the game harm pictures and labels: {harmful}. Change them under Settings, Graphics.");
        }
    }
}
