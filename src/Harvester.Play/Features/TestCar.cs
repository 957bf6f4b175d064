using Harvester.Capture.Ports;
using Harvester.Play.Settings;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The test car of the thesis: created beside the player, one at a time.</summary>
public sealed class TestCar : ILastingFeature
{
    private const double LoadMilliseconds = 10_000;
    private const double MetresBesidePlayer = 4;
    private const int MetallicBlack = 0;
    private const int MetallicOrange = 38;
    private readonly PlayerSettings _settings;
    private readonly PlayerMessages _messages;
    private readonly IModels _models;
    private readonly IVehicles _vehicles;
    private readonly IClock _clock;
    private double _requestedAt;
    private int _requestedModel;
    private int _heldModel;
    private int _car;

    /// <summary>Creates the feature.</summary>
    /// <param name="settings">Model and number plate of the car.</param>
    /// <param name="messages">Reports the result.</param>
    /// <param name="models">The game's models.</param>
    /// <param name="vehicles">The game's vehicles.</param>
    /// <param name="clock">Real time.</param>
    public TestCar(PlayerSettings settings, PlayerMessages messages, IModels models, IVehicles vehicles, IClock clock)
    {
        _settings = settings;
        _messages = messages;
        _models = models;
        _vehicles = vehicles;
        _clock = clock;
    }

    /// <inheritdoc/>
    public string Name => "The test car";

    /// <inheritdoc/>
    public bool IsOn => _requestedModel != 0;

    /// <inheritdoc/>
    public bool IsBusy => false;

    /// <summary>Requests a car; it appears when the game has loaded its model, some ticks later.</summary>
    public void Spawn()
    {
        int model = ModelHash.Of(_settings.CarModel);
        if (!_models.IsVehicle(model))
        {
            _messages.Tell($"The game has no vehicle '{_settings.CarModel}'. Change Model under [TestCar] in GtaDataHarvester.ini.");
            return;
        }

        _requestedModel = model;
        _requestedAt = _clock.Milliseconds;
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_requestedModel == 0)
        {
            Release();
            return;
        }

        _heldModel = _requestedModel;
        if (_models.Load(_requestedModel))
        {
            try
            {
                Replace(_requestedModel);
            }
            finally
            {
                Stop();
            }
        }
        else if (_clock.Milliseconds - _requestedAt > LoadMilliseconds)
        {
            Stop();
            _messages.Tell($"The game did not load the vehicle '{_settings.CarModel}'. Try again in a moment.");
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _requestedModel = 0;
        Release();
    }

    /// <summary>Removes the car from the game.</summary>
    public void Finish()
    {
        try
        {
            Stop();
        }
        finally
        {
            Remove();
        }
    }

    /// <summary>Lets the game unload the model; if the game refuses, the next tick tries again.</summary>
    private void Release()
    {
        if (_heldModel != 0)
        {
            _models.Release(_heldModel);
            _heldModel = 0;
        }
    }

    /// <summary>
    /// Removes the car. Its handle is kept until it is gone: if the game refuses, this is repeated with the next car and at the script's
    /// end.
    /// </summary>
    private void Remove()
    {
        if (_car != 0 && _vehicles.Exists(_car))
        {
            _vehicles.Remove(_car);
        }

        _car = 0;
    }

    private void Replace(int model)
    {
        Remove();
        int car = _vehicles.MakeBesidePlayer(model, MetresBesidePlayer);
        if (car == 0)
        {
            _messages.Tell("The game has no room for another vehicle. Try again away from traffic.");
            return;
        }

        _car = car;
        _vehicles.Prepare(car, MetallicBlack, MetallicOrange, _settings.CarPlate);
        _messages.Tell("The test car is here.");
    }
}
