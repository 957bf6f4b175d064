using Harvester.Capture.Ports;
using Harvester.Capture.Surveys;
using Harvester.Geometry.Paint;
using Harvester.Play.Surveys.Paint;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>
/// Photographs the roads around the player from above, as a session from which "harvester roads paint" measures the painted lines. What
/// earlier surveys have photographed is left out, so that a survey continues where the last one stopped.
/// </summary>
public sealed class PaintSurveying : ILastingFeature
{
    /// <summary>Pictures after which the survey's own pace is known.</summary>
    private const int PicturesOfPace = 5;

    private readonly Harvest _harvest;
    private readonly CameraMount _mount;
    private readonly GamePorts _game;
    private readonly IDrivenCar _car;
    private readonly string _roadFile;
    private readonly string _folder;
    private readonly PlayerMessages _messages;
    private Task<PreparedSurvey>? _preparing;
    private PreparedSurvey? _survey;
    private SurveyView? _view;
    private PaintTour? _tour;
    private double _startedAt;

    /// <summary>Creates a survey that is off.</summary>
    /// <param name="harvest">Takes the pictures.</param>
    /// <param name="mount">The camera and its vehicle.</param>
    /// <param name="game">The game.</param>
    /// <param name="car">The vehicle with the camera.</param>
    /// <param name="roadFile">The file of the roads.</param>
    /// <param name="folder">The folder for the sessions of all surveys of paint.</param>
    /// <param name="messages">Reports what becomes of it.</param>
    public PaintSurveying(
        Harvest harvest,
        CameraMount mount,
        GamePorts game,
        IDrivenCar car,
        string roadFile,
        string folder,
        PlayerMessages messages
    )
    {
        _harvest = harvest;
        _mount = mount;
        _game = game;
        _car = car;
        _roadFile = roadFile;
        _folder = folder;
        _messages = messages;
    }

    /// <summary>Why no survey can start now; null if one can.</summary>
    public Func<string?> Obstacle { get; init; } = static () => null;

    /// <summary>
    /// Tells, in the tick in which a survey begins, how another thread finds out where its roads lie; null for all roads.
    /// </summary>
    public Func<Func<SurveyArea?>> Area { get; init; } = static () => static () => null;

    /// <summary>Ground in a pixel, metres.</summary>
    public double MetresPerPixel { get; init; } = SurveyView.UsualMetresPerPixel;

    /// <summary>How long it waits at each place.</summary>
    public TourTimes Times { get; init; } = TourTimes.OfGame;

    /// <inheritdoc/>
    public string Name => "The survey of paint";

    /// <inheritdoc/>
    public bool IsOn => _preparing is not null || _survey is not null;

    /// <inheritdoc/>
    public bool IsBusy => _preparing is { IsCompleted: false };

    /// <summary>A line about the survey; null if it is off.</summary>
    public string? Line =>
        _survey is { } survey
            ? FormattableString.Invariant($"PAINT  {Pictures} of {survey.Plan.Stations.Count} pictures  ") + LeftText(survey)
        : _preparing is not null ? "PAINT  planning the pictures"
        : null;

    private int Pictures => _harvest.Captured;

    /// <summary>Starts or continues the survey, or ends the one that is running.</summary>
    public void Toggle()
    {
        if (IsOn)
        {
            Stop();
        }
        else if ((Obstacle() ?? _harvest.Problem()) is { } obstacle)
        {
            _messages.Tell(obstacle);
        }
        else if (_harvest.IsBusy)
        {
            _messages.Tell("The last harvest is still being written. Try again in a moment.");
        }
        else
        {
            _mount.Mount();
            if (_mount.IsMounted)
            {
                double aspect = _game.World.ReadCamera().WindowAspect;
                SurveyView view = _view = new SurveyView(SurveyView.ImageFor(aspect), _harvest.Options.Lens, MetresPerPixel);
                Func<SurveyArea?> area = Area();
                _preparing = Task.Run(() =>
                    PreparedSurvey.Of(_roadFile, _folder, view, area) with
                    {
                        Folder = SessionPlace.NewIn(_folder, "paint"),
                    }
                );
            }
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_preparing is { } preparing && Background.IsDone(nameof(PaintSurveying), () => preparing.IsCompleted))
        {
            _preparing = null;
            Begin(preparing);
        }
        else if (_survey is { } survey && !_harvest.IsOn)
        {
            // The harvest has already reported its end, with any fault.
            End(survey, _harvest.LastFault is null && _tour?.HasVisitedAll == true);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        if (_preparing is not null)
        {
            _preparing = null;
            _mount.Stop();
            _messages.Tell("The survey of paint was stopped before its first picture.");
        }
        else if (_survey is { } survey)
        {
            _harvest.Stop();
            End(survey, hasVisitedAll: false);
        }
    }

    /// <inheritdoc/>
    public void Finish() => Stop();

    private void Begin(Task<PreparedSurvey> prepared)
    {
        if (prepared.Exception?.InnerException is { } failure)
        {
            _mount.Stop();
            _messages.Tell($"The survey of paint cannot begin: {failure.Message}");
            return;
        }

        PreparedSurvey survey = prepared.Result;
        int pictures = survey.Plan.Stations.Count;
        if (pictures == 0)
        {
            _mount.Stop();
            _messages.Tell(
                survey.Earlier > 0
                    ? $"All roads here are photographed from above, in {_folder}."
                    : "No road lies here. Survey the roads first, or name another road file."
            );
            return;
        }

        if (_harvest.IsOn || _harvest.IsBusy)
        {
            _mount.Stop();
            _messages.Tell("The survey of paint cannot begin: a harvest was started meanwhile. End it first.");
            return;
        }

        string earlier = survey.Earlier > 0 ? $", after {survey.Earlier} of earlier surveys" : string.Empty;
        _messages.Tell(
            $"The survey of paint takes {Counted.Of(pictures, "picture")}{earlier}, in about "
                + $"{SurveyDuration.Text(pictures, SurveyDuration.UsualSecondsPerPicture)}. Stay in the vehicle; the same key stops it."
        );
        var tour = new PaintTour(_game with { Roads = null, Paint = null }, _car, survey.Plan.Stations, _view!, Times);
        _harvest.StartIn(survey.Folder, SurveyOptions.Of(_harvest.Options, _view!), tour);
        if (_harvest.IsOn)
        {
            _tour = tour;
            _survey = survey;
            _startedAt = _game.Clock.Milliseconds;
        }
        else
        {
            _mount.Stop();
        }
    }

    private void End(PreparedSurvey survey, bool hasVisitedAll)
    {
        _survey = null;
        _mount.Stop();
        int left = survey.Plan.Stations.Count - Pictures;
        string pictures = $"{Pictures} of {Counted.Of(survey.Plan.Stations.Count, "picture")}";
        _messages.Tell(
            left <= 0 ? $"The survey of paint is done: {Counted.Of(Pictures, "picture")}, in {_folder}."
            : hasVisitedAll
                ? $"The survey of paint took {pictures}. At {Counted.Of(left, "place")} the ground did not load or the vehicle did not "
                    + "stand; the next survey tries again."
            : $"The survey of paint ended after {pictures}. The next one continues there."
        );
    }

    private string LeftText(PreparedSurvey survey)
    {
        double seconds = (_game.Clock.Milliseconds - _startedAt) / 1000;
        double each = Pictures >= PicturesOfPace ? seconds / Pictures : SurveyDuration.UsualSecondsPerPicture;
        return $"{SurveyDuration.Text(Math.Max(0, survey.Plan.Stations.Count - Pictures), each)} left";
    }
}
