using Harvester.Capture.Ports;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Measures the models of signs and lights in turn, and saves the results for later harvests.</summary>
public sealed class FaceSurveying : ILastingFeature
{
    private readonly ISurveyStage _stage;
    private readonly ISurveyCamera? _camera;
    private readonly IReadOnlyList<SurveyedModel> _models;
    private readonly MeasuredFaces _measured;
    private readonly Harvest _harvest;
    private readonly IMount _mount;
    private readonly PlayerMessages _messages;
    private readonly IClock _clock;
    private readonly double _budgetMilliseconds;
    private readonly List<FaceSurvey> _leaving = [];
    private FaceSurvey? _survey;
    private bool _isOn;

    /// <summary>Creates a survey that is off.</summary>
    /// <param name="stage">Places the models.</param>
    /// <param name="camera">Takes photographs; null to take none.</param>
    /// <param name="models">The models to measure.</param>
    /// <param name="measured">Receives the rows.</param>
    /// <param name="harvest">While it runs, no survey starts.</param>
    /// <param name="mount">Restores the view before a survey, which needs it for photographs.</param>
    /// <param name="messages">Reports the results.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="budgetMilliseconds">Maximum time of rays per tick, milliseconds.</param>
    public FaceSurveying(
        ISurveyStage stage,
        ISurveyCamera? camera,
        IReadOnlyList<SurveyedModel> models,
        MeasuredFaces measured,
        Harvest harvest,
        IMount mount,
        PlayerMessages messages,
        IClock clock,
        double budgetMilliseconds
    )
    {
        _stage = stage;
        _camera = camera;
        _models = models;
        _measured = measured;
        _harvest = harvest;
        _mount = mount;
        _messages = messages;
        _clock = clock;
        _budgetMilliseconds = budgetMilliseconds;
    }

    /// <inheritdoc/>
    public string Name => "The survey of signs";

    /// <inheritdoc/>
    public bool IsOn => _isOn;

    /// <inheritdoc/>
    public bool IsBusy => _measured.IsBusy;

    /// <summary>Whether a photograph is being taken, so that nothing may be drawn over it.</summary>
    public bool IsPictureNear => _survey?.IsPhotographing ?? false;

    /// <summary>A line about the survey; null if it is off.</summary>
    public string? Line =>
        _isOn ? FormattableString.Invariant($"SIGNS  {_survey?.Done ?? 0} of {_models.Count}  {_survey?.Current}") : null;

    /// <summary>Whether nothing is left to do but to write the last rows.</summary>
    private bool IsMeasured => _survey is { } survey && survey.Done == _models.Count;

    /// <summary>Continues the survey, or ends the one that is running.</summary>
    public void Toggle()
    {
        if (IsMeasured)
        {
            _messages.Tell($"All {_models.Count} models are measured; the survey of signs ends when they are written.");
        }
        else if (_isOn)
        {
            Interrupt("was stopped");
        }
        else if (_harvest.IsOn)
        {
            _messages.Tell("End the harvest first, then survey the signs.");
        }
        else if (_mount.IsMounted)
        {
            _messages.Tell("Unmount the camera first, then survey the signs: the survey takes photographs.");
        }
        else
        {
            _isOn = true;
            _messages.Tell("The survey of signs is on: stay where you are.");
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        GiveBack();
        if (!_isOn || (_survey is null && _measured.Open() is null))
        {
            return;
        }

        if (_mount.IsMounted && !IsMeasured)
        {
            Interrupt("ended because the camera was mounted");
            return;
        }

        _survey ??= new FaceSurvey(_stage, _models, _measured.Open()!, _clock, _budgetMilliseconds, _camera);
        _survey.Step();
        if (_survey.IsOver)
        {
            End(_survey);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _isOn = false;
        if (_survey is { } survey)
        {
            _leaving.Add(survey);
            _survey = null;
        }

        GiveBack();
    }

    /// <inheritdoc/>
    public void Finish()
    {
        Stop();
        _measured.Wait();
    }

    /// <summary>Ends surveys; what the game refuses to remove now is removed in a later tick.</summary>
    private void GiveBack()
    {
        _leaving.ForEach(survey => survey.Dispose());
        _leaving.RemoveAll(survey => !survey.HasLeftSomething);
    }

    private void Interrupt(string how)
    {
        if (_survey is not { } survey)
        {
            Stop();
            _messages.Tell($"The survey of signs {how} before its first model.");
        }
        else
        {
            Stop();
            _messages.Tell(
                FormattableString.Invariant(
                    $"The survey of signs {how} after {survey.Done} of {_models.Count} models. The next survey continues there."
                )
            );
        }
    }

    private void End(FaceSurvey survey)
    {
        Stop();
        int faces = _measured.Open()?.Table.Faces.Count() ?? 0;
        _messages.Tell(
            survey.Fault
                ?? FormattableString.Invariant($"All {_models.Count} models are surveyed: {Counted.Of(faces, "face")}, in ")
                    + $"{_measured.Path}. They are in use from now on."
        );
    }
}
